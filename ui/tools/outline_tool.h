// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Draws the outline of the rock, or of a region within it.
#pragma once

#include "ui/tools/line_tool.h"

namespace keyblock {

class OutlineTool : public LineTool {
    Q_OBJECT

public:
    using LineTool::LineTool;

    QString id() const override { return "outline"; }
    QString title() const override { return what_ == 0 ? tr("Outline") : tr("Region"); }
    std::vector<ToolField> fields() override;

protected:
    bool isOutline() const override { return true; }
    Edit make(const std::vector<Point>& points) const override;
    QString step() const override;

private:
    int what_ = 0;  // 0: rock, 1: region
};

}  // namespace keyblock
