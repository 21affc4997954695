// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Draws a single joint along a line.
#pragma once

#include "ui/tools/line_tool.h"

namespace keyblock {

class JointTool : public LineTool {
    Q_OBJECT

public:
    using LineTool::LineTool;

    QString id() const override { return "joint"; }
    QString title() const override { return tr("Joint"); }
    std::vector<ToolField> fields() override;

protected:
    bool isOutline() const override { return false; }
    Edit make(const std::vector<Point>& points) const override;

private:
    SceneJoint joint_;
};

}  // namespace keyblock
