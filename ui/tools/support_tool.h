// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Adds a support to a side of the domain, to a point, or to a whole block.
#pragma once

#include "ui/tools/tool.h"

namespace keyblock {

class SupportTool : public Tool {
    Q_OBJECT

public:
    using Tool::Tool;

    QString id() const override { return "support"; }
    QString title() const override { return tr("Support"); }
    QString prompt() const override;
    QString detail() const override;
    std::vector<ToolField> fields() override;
    void press(const Pointed& at) override;
    void move(const Pointed& at) override { cursor_ = at.place; }
    void leave() override { cursor_.reset(); }
    bool accepts(const Snap&) const override { return what_ != Whole; }  // snap points lie on faces, not in blocks
    void paint(QPainter& painter, const CanvasMap& map) const override;

private:
    enum What { Side, Place, Whole };
    Support supportAt(const Point& place) const;
    std::optional<BoundarySide> sideAt(const Point& place) const;

    int what_ = Side;
    int fix_ = 0;  // 0: xy, 1: x, 2: y
    std::optional<Point> cursor_;
};

}  // namespace keyblock
