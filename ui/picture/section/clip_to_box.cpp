// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/picture/section/clip_to_box.h"

#include <algorithm>

namespace keyblock {

namespace {

/// Keeps the part of a polygon where sign · (coordinate − limit) is not positive.
std::vector<Point> halved(const std::vector<Point>& polygon, int axis, double sign, double limit) {
    std::vector<Point> kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Point &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        const double da = sign * (a[axis] - limit), db = sign * (b[axis] - limit);
        if (da <= 0.0) kept.push_back(a);
        if ((da < 0.0 && db > 0.0) || (da > 0.0 && db < 0.0)) kept.push_back(a + da / (da - db) * (b - a));
    }
    return kept;
}

}  // namespace

std::vector<Point> clippedToBox(std::vector<Point> polygon, const Box& box) {
    for (int axis = 0; axis < 2; ++axis) {
        polygon = halved(polygon, axis, 1.0, box.max[axis]);
        polygon = halved(polygon, axis, -1.0, box.min[axis]);
    }
    return polygon.size() < 3 ? std::vector<Point>{} : polygon;
}

std::optional<std::pair<Point, Point>> clippedToBox(const Point& a, const Point& b, const Box& box) {
    double from = 0.0, to = 1.0;
    for (int axis = 0; axis < 2; ++axis) {
        const double along = b[axis] - a[axis];
        if (along == 0.0) {
            if (a[axis] < box.min[axis] || a[axis] > box.max[axis]) return std::nullopt;
            continue;
        }
        double enter = (box.min[axis] - a[axis]) / along, leave = (box.max[axis] - a[axis]) / along;
        if (enter > leave) std::swap(enter, leave);
        from = std::max(from, enter);
        to = std::min(to, leave);
    }
    if (from > to) return std::nullopt;
    return std::pair<Point, Point>{a + from * (b - a), a + to * (b - a)};
}

}  // namespace keyblock
