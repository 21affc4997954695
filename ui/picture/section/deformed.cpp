// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/picture/section/deformed.h"

#include "geometry/polygon.h"

#include <algorithm>
#include <cassert>

namespace keyblock {

std::vector<std::vector<Point>> cornersBefore(const SolvedBlocks& solved) {
    std::vector<std::vector<Point>> corners;
    corners.reserve(solved.blocks.size());
    for (const SolvedBlock& block : solved.blocks) {
        corners.push_back(counterClockwise(block.points));
        for (Point& corner : corners.back()) corner += solved.origin;
    }
    return corners;
}

std::vector<Point> deformed(const std::vector<Point>& before, const std::vector<Point>& now, double factor) {
    assert(before.size() == now.size());
    if (factor == 1.0) return now;
    std::vector<Point> drawn;
    drawn.reserve(now.size());
    for (std::size_t i = 0; i < now.size(); ++i) drawn.push_back(before[i] + factor * (now[i] - before[i]));
    return drawn;
}

Point carriedAlong(const Point& place, const std::vector<Point>& now, const std::vector<Point>& drawn) {
    const auto nearest = std::min_element(now.begin(), now.end(), [&](const Point& a, const Point& b) {
        return (a - place).squaredNorm() < (b - place).squaredNorm();
    });
    if (nearest == now.end()) return place;
    return place + drawn[nearest - now.begin()] - *nearest;
}

std::vector<Point> deformedNodes(const Bolt& bolt, const BoltFrame& frame, double factor) {
    const Point along = (bolt.head - bolt.farEnd).normalized();
    std::vector<Point> before, now;
    for (const BoltNodeFrame& node : frame.nodes) {
        before.push_back(bolt.farEnd + node.s * along);
        now.push_back(node.position);
    }
    return deformed(before, now, factor);
}

}  // namespace keyblock
