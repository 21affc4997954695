// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Draws a single block that is not part of the rock to be cut.
#pragma once

#include "ui/tools/line_tool.h"

namespace keyblock {

class BlockTool : public LineTool {
    Q_OBJECT

public:
    using LineTool::LineTool;

    QString id() const override { return "block"; }
    QString title() const override { return tr("Block"); }
    std::vector<ToolField> fields() override;

protected:
    bool isOutline() const override { return true; }
    Edit make(const std::vector<Point>& points) const override;

private:
    Block block_;
};

}  // namespace keyblock
