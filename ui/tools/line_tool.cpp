// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/line_tool.h"

#include "geometry/angle.h"
#include "geometry/polygon.h"
#include "ui/canvas/canvas.h"
#include "ui/tools/tool_painter.h"

namespace keyblock {
namespace {

constexpr double closingReach = 9.0;  // [px]

std::vector<Point> rectangle(const Point& a, const Point& b) {
    const Point low = a.cwiseMin(b), high = a.cwiseMax(b);
    return {low, {high.x(), low.y()}, high, {low.x(), high.y()}};
}

double lengthOf(const std::vector<Point>& points) {
    double length = 0.0;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) length += (points[i + 1] - points[i]).norm();
    return length;
}

}  // namespace

QString LineTool::prompt() const {
    if (isRectangle()) return points_.empty() ? tr("pick the first corner") : tr("pick the opposite corner");
    if (points_.empty()) return isOutline() ? tr("pick the first corner") : tr("pick the first point");
    if (points_.size() < needed()) return isOutline() ? tr("pick the next corner") : tr("pick the next point");
    return isOutline() ? tr("pick the next corner; Enter or the first corner closes the polygon")
                       : tr("pick the next point; Enter ends the line");
}

QString LineTool::detail() const {
    const std::vector<Point> line = shown();
    if (line.size() < 2) return {};
    if (isRectangle()) {
        const Point size = line[2] - line[0];
        return tr("%1 × %2").arg(lengthText(size.x()), lengthText(size.y()));
    }
    if (isOutline() && line.size() > 2) {
        return tr("%1 corners, %2").arg(points_.size()).arg(areaText(std::abs(signedArea(line))));
    }
    const QString length = lengthText(lengthOf(line));
    return points_.size() == 1 ? tr("1 point, %1").arg(length) : tr("%1 points, %2").arg(points_.size()).arg(length);
}

QString LineTool::commitText() const {
    const bool ready = isRectangle() ? false : points_.size() >= needed();
    return ready ? tr("Place %1").arg(title().toLower()) : QString();
}

ToolField LineTool::shapeField() {
    return choiceField("shape", tr("Shape"), {tr("rectangle"), tr("polygon")}, shape_, [this] {
        points_.clear();
        Q_EMIT changed();
    });
}

void LineTool::press(const Pointed& at) {
    cursor_ = at.place;
    if (isRectangle()) {
        if (points_.empty())
            points_ = {at.place};
        else
            finish(rectangle(points_.front(), at.place));
        return;
    }
    const double reach = bench().metres(closingReach);
    if (isOutline() && points_.size() >= 3 && (at.place - points_.front()).norm() <= reach && !at.typed) {
        finish(points_);
        return;
    }
    if (points_.empty() || (at.place - points_.back()).norm() > 1e-9) points_.push_back(at.place);
}

void LineTool::doubleClick(const Pointed& at) {
    if (isRectangle() || points_.size() < needed()) return press(at);
    finish(points_);
}

bool LineTool::finish(const std::vector<Point>& points) {
    if (!bench().add(make(points), step())) return false;
    points_.clear();
    return true;
}

bool LineTool::enter() { return !isRectangle() && points_.size() >= needed() && finish(points_); }

bool LineTool::close() { return isOutline() && enter(); }

bool LineTool::back() {
    if (points_.empty()) return false;
    points_.clear();
    return true;
}

bool LineTool::undoPoint() {
    if (points_.empty()) return false;
    points_.pop_back();
    return true;
}

std::optional<Point> LineTool::previous() const {
    return points_.empty() ? std::nullopt : std::optional(points_.back());
}

std::vector<Point> LineTool::shown() const {
    std::vector<Point> line = points_;
    if (!cursor_ || points_.empty()) return line;
    if (isRectangle()) return rectangle(points_.front(), *cursor_);
    line.push_back(*cursor_);
    return line;
}

void LineTool::paint(QPainter& painter, const CanvasMap& map) const {
    const std::vector<Point> line = shown();
    if (line.empty()) return;
    ToolPainter ink(painter, map, bench().theme());
    if (isOutline() && line.size() > 2) ink.ghostFill(line);
    ink.ghost(line, isOutline() && line.size() > 2);
    if (!isRectangle() && points_.size() > 1) ink.chosen(points_, false, 1.6);
    for (const Point& point : points_) ink.corner(point);
    if (isRectangle() && line.size() == 4) {
        ink.dimension(line[0], line[1], lengthText(line[1].x() - line[0].x()), -18.0);
        ink.dimension(line[1], line[2], lengthText(line[2].y() - line[1].y()), -18.0);
    } else if (line.size() > points_.size() && line.size() > 1) {
        const Point way = line.back() - line[line.size() - 2];
        const double angle = std::atan2(way.y(), way.x()) / radiansPerDegree;
        ink.dimension(line[line.size() - 2], line.back(), lengthText(way.norm()) + "  " + angleText(angle), 18.0);
    }
}

}  // namespace keyblock
