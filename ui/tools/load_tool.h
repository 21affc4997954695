// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Adds a load to a stage: a force at a point, a force on a block, or a pressure along a
// line.
#pragma once

#include "ui/tools/tool.h"

namespace keyblock {

class LoadTool : public Tool {
    Q_OBJECT

public:
    using Tool::Tool;

    QString id() const override { return "load"; }
    QString title() const override { return tr("Load"); }
    QString prompt() const override;
    std::vector<ToolField> fields() override;
    void begin() override;
    void end() override { first_.reset(); }
    void press(const Pointed& at) override;
    void move(const Pointed& at) override { cursor_ = at.place; }
    void leave() override { cursor_.reset(); }
    bool back() override;
    bool undoPoint() override { return back(); }
    std::optional<Point> previous() const override { return first_; }
    bool accepts(const Snap&) const override { return what_ != OnBlock; }  // snap points lie on faces, not in blocks
    void paint(QPainter& painter, const CanvasMap& map) const override;

private:
    enum What { AtPoint, OnBlock, Pressure };
    void place(Load load);

    int what_ = AtPoint, stage_ = 0;
    Point force_{0.0, -100e3};  // [N]
    double pressure_ = 100e3;  // [Pa]
    std::optional<Point> first_, cursor_;
};

}  // namespace keyblock
