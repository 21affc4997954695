// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Prescribes the displacement of a block in a stage.
#pragma once

#include "ui/tools/tool.h"

namespace keyblock {

class MotionTool : public Tool {
    Q_OBJECT

public:
    using Tool::Tool;

    QString id() const override { return "motion"; }
    QString title() const override { return tr("Motion"); }
    QString prompt() const override;
    std::vector<ToolField> fields() override;
    void begin() override;
    void press(const Pointed& at) override;
    void move(const Pointed& at) override { cursor_ = at.place; }
    void leave() override { cursor_.reset(); }
    bool accepts(const Snap&) const override { return false; }  // snap points lie on faces, not in blocks
    void paint(QPainter& painter, const CanvasMap& map) const override;

private:
    int stage_ = 0, axis_ = 0;  // axis_: 0: x, 1: y
    double displacement_ = 0.004;  // at the end of the stage [m]
    std::optional<Point> cursor_;
};

}  // namespace keyblock
