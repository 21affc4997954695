// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/picture/section/placement.h"

#include "geometry/segment.h"
#include "ui/picture/section/clip_to_box.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace keyblock {

namespace {

constexpr double nearFoot = 2.0, step = 2.0, farthest = 40.0;  // [mm] distances along a leader

}  // namespace

Box boxAbout(const Point& centre, const Point& size) { return {centre - 0.5 * size, centre + 0.5 * size}; }

bool Placement::isFree(const Box& box) const {
    const bool inside = (box.min.array() >= frame_.min.array()).all() && (box.max.array() <= frame_.max.array()).all();
    return inside && std::none_of(boxes_.begin(), boxes_.end(), [&](const Box& other) { return meets(box, other); }) &&
           std::none_of(lines_.begin(), lines_.end(), [&](const Line& line) {
               return clippedToBox(line.a, line.b, grown(box, line.half)).has_value();
           });
}

bool Placement::leaderIsFree(const Point& at, const Point& to) const {
    const double length = (to - at).norm();
    if (length <= nearFoot * perMm_) return true;
    const Point from = at + nearFoot * perMm_ / length * (to - at);
    return std::none_of(lines_.begin(), lines_.end(),
                        [&](const Line& line) {
                            return !line.leadersCross && crossing(from, to, line.a, line.b).has_value();
                        }) &&
           std::none_of(boxes_.begin(), boxes_.end(),
                        [&](const Box& box) { return clippedToBox(from, to, box).has_value(); });
}

std::optional<Box> Placement::place(const Point& size, const std::vector<Point>& centres) {
    for (const Point& centre : centres)
        if (const Box box = boxAbout(centre, size); isFree(box)) {
            keepOff(box);
            return box;
        }
    return std::nullopt;
}

std::optional<Box> Placement::placeRound(const Point& size, const Point& at, const Point& first) {
    constexpr int directions = 16;
    const double start = std::atan2(first.y(), first.x());
    for (double away = 0.5 * size.norm() + step * perMm_; away < farthest * perMm_; away += step * perMm_)
        for (int i = 0; i < directions; ++i) {
            const int turn = (i % 2 ? 1 : -1) * ((i + 1) / 2);
            const double angle = start + turn * 2.0 * std::numbers::pi / directions;
            const Box box = boxAbout(at + away * Point(std::cos(angle), std::sin(angle)), size);
            if (!isFree(box) || !leaderIsFree(at, 0.5 * (box.min + box.max))) continue;
            keepOff(box);
            return box;
        }
    return std::nullopt;
}

}  // namespace keyblock
