// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Adds a monitor for a point, for the opening between two points, or for a bolt.
#pragma once

#include "ui/tools/tool.h"

namespace keyblock {

class MonitorTool : public Tool {
    Q_OBJECT

public:
    using Tool::Tool;

    QString id() const override { return "monitor"; }
    QString title() const override { return tr("Monitor"); }
    QString prompt() const override;
    std::vector<ToolField> fields() override;
    void end() override { first_.reset(); }
    void press(const Pointed& at) override;
    void move(const Pointed& at) override { cursor_ = at.place; }
    void leave() override { cursor_.reset(); }
    bool back() override;
    bool undoPoint() override { return back(); }
    std::optional<Point> previous() const override { return first_; }
    void paint(QPainter& painter, const CanvasMap& map) const override;

private:
    enum What { AtPoint, Opening, OnBolt };
    std::optional<Monitor> boltAt(const Point& place) const;
    void place(const Monitor& monitor);

    int what_ = AtPoint, quantity_ = 0;
    std::optional<Point> first_, cursor_;
};

}  // namespace keyblock
