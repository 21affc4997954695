// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/bolt/acts_across.h"

#include "geometry/polygon.h"
#include "solver/scene/lookup.h"

#include <algorithm>
#include <cmath>

namespace keyblock {
namespace {

constexpr double straight = 1e-9;  // sine of an angle below which two directions are parallel

/// The line of a bolt, in the scene's coordinates.
struct BoltLine {
    const Scene& scene;
    Point place{0.0, 0.0}, axis{1.0, 0.0};
    double tolerance = 0.0;  // [m]

    bool isAlong(const Point& direction) const {
        return std::abs(cross(direction, axis)) <= straight * direction.norm();
    }
    bool isOn(const Point& point) const { return std::abs(cross(point - place, axis)) <= tolerance; }
    /// True if the centroid of the block at `point` lies on the line.
    bool passesBlockAt(const Point& point) const {
        const int block = blockAt(scene, point);
        return block >= 0 && isOn(moments(scene.blocks[block].points).centroid);
    }
};

bool pulls(const BoltLine& line, const Load& load) {
    if (load.along || !line.isAlong(load.force)) return false;
    if (const auto& point = load.at ? load.at : load.point) return line.isOn(*point);
    return load.blockAt && line.passesBlockAt(*load.blockAt);
}

bool pulls(const BoltLine& line, const Motion& motion) {
    return motion.rotation == Rotation::Held && line.isAlong(motion.axis);
}

bool pulls(const BoltLine& line, const InitialVelocity& start) {
    return start.spin == 0.0 && line.isAlong(start.velocity) && line.passesBlockAt(start.blockAt);
}

bool pulls(const BoltLine& line, const Stage& stage) {
    const auto each = [&](const auto& list) {
        return std::ranges::all_of(list, [&](const auto& one) { return pulls(line, one); });
    };
    return !stage.baseAcceleration && !stage.bodyAcceleration && stage.dilations.empty() && each(stage.loads) &&
           each(stage.motions) && each(stage.initialVelocities);
}

/// True if every edge is parallel or normal to the bolt and the block has no initial stress.
bool isSquare(const BoltLine& line, const Block& block) {
    for (std::size_t i = 0; i < block.points.size(); ++i) {
        const Point edge = block.points[(i + 1) % block.points.size()] - block.points[i];
        if (!line.isAlong(edge) && !line.isAlong(turnLeft(edge))) return false;
    }
    return block.initialStress == Block{}.initialStress;
}

}  // namespace

bool actsAcross(const Scene& scene, const BoltModel& bolt, const Model& model) {
    const BoltLine line{scene, bolt.farEnd + model.origin, bolt.axis, model.tolerance};
    const auto held = [](const Support& support) { return support.blockAt.has_value(); };
    const auto square = [&](const Block& block) { return isSquare(line, block); };
    const auto pull = [&](const Stage& stage) { return pulls(line, stage); };
    return scene.bolts.size() > 1 || scene.inSituStress || scene.analysis.gravity != Point(0.0, 0.0) ||
           !std::ranges::all_of(scene.supports, held) || !std::ranges::all_of(scene.blocks, square) ||
           !std::ranges::all_of(scene.stages, pull);
}

}  // namespace keyblock
