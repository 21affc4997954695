// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Adds a joint set. The traces are previewed while the user sets spacing, dip and
// scatter; a point on a trace and the direction can also be picked on the canvas.
#pragma once

#include "ui/tools/tool.h"

namespace keyblock {

class JointSetTool : public Tool {
    Q_OBJECT

public:
    using Tool::Tool;

    QString id() const override { return "joint-set"; }
    QString title() const override { return tr("Joint set"); }
    QString prompt() const override;
    QString detail() const override;
    std::vector<ToolField> fields() override;
    QString commitText() const override;

    void begin() override;
    void end() override { picked_.reset(); }
    void refresh() override { draw(); }
    void press(const Pointed& at) override;
    void move(const Pointed& at) override { cursor_ = at.place; }
    void leave() override { cursor_.reset(); }
    bool enter() override;
    bool back() override;
    bool undoPoint() override { return back(); }
    std::optional<Point> previous() const override { return picked_; }
    void paint(QPainter& painter, const CanvasMap& map) const override;

private:
    void draw();
    void next();
    void tell();

    SceneJointSet set_;
    std::vector<ObjectLine> traces_;  // traces of `set_`
    std::optional<Point> picked_;  // a point on a trace; the direction is picked next
    std::optional<Point> cursor_;
};

}  // namespace keyblock
