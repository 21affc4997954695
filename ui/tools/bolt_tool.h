// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Places a single bolt. Near a wall, the head lies on the wall and the bolt is
// perpendicular to it; elsewhere the user picks the head and the far end.
#pragma once

#include "ui/edit/wall_at.h"
#include "ui/tools/tool.h"

namespace keyblock {

class BoltTool : public Tool {
    Q_OBJECT

public:
    using Tool::Tool;

    QString id() const override { return "bolt"; }
    QString title() const override { return tr("Bolt"); }
    QString prompt() const override;
    QString detail() const override;
    std::vector<ToolField> fields() override;
    QString commitText() const override;

    void begin() override;
    void end() override { head_.reset(); }
    void press(const Pointed& at) override;
    void move(const Pointed& at) override;
    void leave() override { cursor_.reset(), wall_.reset(); }
    bool enter() override;
    bool back() override;
    bool undoPoint() override { return back(); }
    std::optional<Point> previous() const override { return head_; }
    bool accepts(const Snap& snap) const override;
    void paint(QPainter& painter, const CanvasMap& map) const override;

private:
    bool place(const Point& head, const Point& farEnd);
    Point squareEnd() const;  // far end of a bolt perpendicular to the wall. \pre `headWall_`

    Bolt bolt_;
    double length_ = 2.4;  // [m]
    std::optional<WallPlace> wall_;  // wall under the mouse
    std::optional<WallPlace> headWall_;  // wall on which the picked head lies
    std::optional<Point> head_, cursor_;
};

}  // namespace keyblock
