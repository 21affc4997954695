// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Base class of the outline, block and joint tools: the user draws a line point by
// point, or a rectangle by two opposite corners.
#pragma once

#include "ui/tools/tool.h"

namespace keyblock {

class LineTool : public Tool {
    Q_OBJECT

public:
    using Tool::Tool;

    QString prompt() const override;
    QString detail() const override;
    QString commitText() const override;
    void end() override { points_.clear(); }
    void press(const Pointed& at) override;
    void move(const Pointed& at) override { cursor_ = at.place; }
    void doubleClick(const Pointed& at) override;
    void leave() override { cursor_.reset(); }
    bool enter() override;
    bool back() override;
    bool undoPoint() override;
    bool close() override;
    std::optional<Point> previous() const override;
    void paint(QPainter& painter, const CanvasMap& map) const override;

protected:
    virtual bool isOutline() const = 0;  // true if the last point is connected to the first
    virtual Edit make(const std::vector<Point>& points) const = 0;
    virtual QString step() const { return {}; }  // name of the undo step; empty: the default, e.g. `Add joint J3`
    bool isRectangle() const { return isOutline() && shape_ == 0; }
    ToolField shapeField();

private:
    std::size_t needed() const { return isOutline() ? 3 : 2; }
    bool finish(const std::vector<Point>& points);
    std::vector<Point> shown() const;

    std::vector<Point> points_;
    std::optional<Point> cursor_;
    int shape_ = 0;  // 0: rectangle, 1: polygon
};

}  // namespace keyblock
