// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/measure_tool.h"

#include "geometry/angle.h"
#include "geometry/polygon.h"
#include "ui/canvas/canvas_map.h"
#include "ui/tools/tool_painter.h"

#include <cmath>

namespace keyblock {
namespace {

/// The angle at the second of three points, from 0° to 180°.
double angleAt(const Point& a, const Point& middle, const Point& b) {
    const Point p = a - middle, q = b - middle;
    return std::abs(std::atan2(cross(p, q), p.dot(q))) / radiansPerDegree;
}

}  // namespace

QString MeasureTool::prompt() const {
    if (points_.empty() || ended_) return tr("pick the first point");
    return tr("pick the next point; Enter ends the line");
}

QString MeasureTool::detail() const {
    const std::vector<Point> measured = line();
    if (measured.size() < 2) return {};
    const Point way = measured.back() - measured[measured.size() - 2];
    QString text = tr("%1, Δx %2, Δy %3, %4")
                       .arg(lengthText(way.norm()), lengthText(way.x()), lengthText(way.y()),
                            angleText(std::atan2(way.y(), way.x()) / radiansPerDegree));
    if (measured.size() == 2) return text;
    double all = 0.0;
    for (std::size_t i = 0; i + 1 < measured.size(); ++i) all += (measured[i + 1] - measured[i]).norm();
    text += tr(" · total %1, enclosed area %2").arg(lengthText(all), areaText(std::abs(signedArea(measured))));
    return text;
}

std::vector<Point> MeasureTool::line() const {
    std::vector<Point> measured = points_;
    if (cursor_ && !ended_ && !points_.empty()) measured.push_back(*cursor_);
    return measured;
}

void MeasureTool::press(const Pointed& at) {
    if (ended_) points_.clear();
    ended_ = false;
    cursor_ = at.place;
    if (points_.empty() || (at.place - points_.back()).norm() > 1e-12) points_.push_back(at.place);
}

bool MeasureTool::enter() {
    if (points_.size() < 2 || ended_) return false;
    ended_ = true;
    return true;
}

bool MeasureTool::back() {
    if (points_.empty()) return false;
    points_.clear();
    ended_ = false;
    return true;
}

bool MeasureTool::undoPoint() {
    if (points_.empty()) return false;
    points_.pop_back();
    ended_ = false;
    return true;
}

std::optional<Point> MeasureTool::previous() const {
    return points_.empty() || ended_ ? std::nullopt : std::optional(points_.back());
}

void MeasureTool::paint(QPainter& painter, const CanvasMap& map) const {
    const std::vector<Point> measured = line();
    ToolPainter ink(painter, map, bench().theme());
    if (measured.size() > 1) ink.chosen(measured, false, 1.4);
    for (const Point& point : measured) ink.dot(point);
    for (std::size_t i = 0; i + 1 < measured.size(); ++i)
        ink.dimension(measured[i], measured[i + 1], lengthText((measured[i + 1] - measured[i]).norm()), 18.0);
    for (std::size_t i = 1; i + 1 < measured.size(); ++i)
        ink.label(map.toPixel(measured[i]) + QPointF(0.0, 20.0),
                  angleText(angleAt(measured[i - 1], measured[i], measured[i + 1])));
}

}  // namespace keyblock
