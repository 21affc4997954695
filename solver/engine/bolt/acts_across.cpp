// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/bolt/acts_across.h"

#include "geometry/point.h"

#include <algorithm>
#include <cmath>

namespace keyblock {
namespace {

constexpr double straight = 1e-9;  // sine of the angle to the axis, below which a direction is along it

bool isAcross(const Point& direction, const Point& axis) {
    return std::abs(cross(direction, axis)) > straight * direction.norm();
}

bool loadsAcross(const Stage& stage, const Point& axis) {
    return std::ranges::any_of(stage.loads, [&](const Load& load) { return load.along || isAcross(load.force, axis); });
}

bool movesAcross(const Stage& stage, const Point& axis) {
    const auto motion = [&](const Motion& m) { return m.rotation == Rotation::Free || isAcross(m.axis, axis); };
    const auto start = [&](const InitialVelocity& v) { return v.spin != 0.0 || isAcross(v.velocity, axis); };
    return std::ranges::any_of(stage.motions, motion) || std::ranges::any_of(stage.initialVelocities, start);
}

bool shakesAcross(const Stage& stage, const Point& axis) {
    const auto across = [&](const std::optional<Acceleration>& a) { return a && isAcross(a->axis, axis); };
    return across(stage.baseAcceleration) || across(stage.bodyAcceleration);
}

bool stageActsAcross(const Stage& stage, const Point& axis) {
    return !stage.dilations.empty() || loadsAcross(stage, axis) || movesAcross(stage, axis) || shakesAcross(stage, axis);
}

bool hasStress(const Scene& scene) {
    const auto stressed = [](const Block& block) { return block.initialStress != Block{}.initialStress; };
    return scene.inSituStress || std::ranges::any_of(scene.blocks, stressed);
}

/// The edge of a slot's block at one of the slot's ends, as far as it is not square to the axis.
bool endsAskew(const Model& model, const Slot& slot, const Point& end, const Point& axis) {
    const std::vector<Point>& shape = model.blocks[slot.block].shape;
    for (std::size_t i = 0; i < shape.size(); ++i) {
        const Point edge = shape[(i + 1) % shape.size()] - shape[i];
        const Point away = end - shape[i];
        const double along = away.dot(edge) / edge.squaredNorm();
        const bool holds = std::abs(cross(edge, away)) <= model.tolerance * edge.norm() && along >= 0.0 && along <= 1.0;
        if (holds && std::abs(edge.dot(axis)) > straight * edge.norm()) return true;
    }
    return false;
}

}  // namespace

bool actsAcross(const Scene& scene, const Model& model, const Point& axis, const std::vector<Slot>& slots) {
    const auto askew = [&](const Slot& slot) {
        return endsAskew(model, slot, slot.p2, axis) || endsAskew(model, slot, slot.p3, axis);
    };
    return isAcross(scene.analysis.gravity, axis) || hasStress(scene) || std::ranges::any_of(slots, askew) ||
           std::ranges::any_of(scene.stages, [&](const Stage& stage) { return stageActsAcross(stage, axis); });
}

}  // namespace keyblock
