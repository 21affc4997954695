// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Base of the outline, block and joint tools: a line of points drawn one by one, or
// a rectangle by two of its corners.
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
    virtual bool isOutline() const = 0;  // the last point joins the first
    virtual Edit make(const std::vector<Point>& points) const = 0;
    virtual QString step() const { return {}; }  // of undo; empty: `Add joint J3`
    bool isRectangle() const { return isOutline() && shape_ == 0; }
    ToolField shapeField();

private:
    std::size_t needed() const { return isOutline() ? 3 : 2; }
    bool finish(const std::vector<Point>& points);
    std::vector<Point> shown() const;

    std::vector<Point> points_;
    std::optional<Point> cursor_;
    int shape_ = 0;  // rectangle, polygon
};

}  // namespace keyblock
