// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Only the document is changed, as in strength reduction. A load of a later stage
// replaces an earlier load at the same point. Each stage therefore lets the loads of
// the previous stage fade out at their points and applies its own at theirs.
#include "solver/run/frozen_bolts.h"

#include "geometry/polygon.h"
#include "geometry/segment.h"
#include "solver/results/block_forces.h"
#include "solver/scene/lookup.h"
#include "solver/scene/quantity_text.h"
#include "solver/scene/scene_cut.h"
#include "solver/scene/solved_blocks.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <limits>

namespace keyblock {

namespace {

/// Factors over a stage of the forces from its start (`before`) and of the forces at its end (`after`).
struct Change {
    Table before, after;
};
const Change gradual{{{0.0, 1.0}, {1.0, 0.0}}, {{0.0, 0.0}, {1.0, 1.0}}}, atStart{{{0.0, 0.0}}, {}};

/// A bolt force as a load that a scene can contain.
struct FrozenForce {
    int row = -1;  // row of the block, or of its cell, in the frame
    Point blockAt{0.0, 0.0}, at{0.0, 0.0};  // [m], at the start of the stage
    Point force{0.0, 0.0};  // [N]
};

bool isHeld(const Scene& cut, std::size_t block) {
    return std::ranges::any_of(cut.supports, [&](const Support& support) {
        if (support.fix != Fix::All) return false;
        if (support.blockAt) return blockAt(cut, *support.blockAt) == static_cast<int>(block);
        const auto onSide = [&](const CutFace& face) { return isOnSide(face, *support.boundary); };
        return support.boundary && std::ranges::any_of(cut.blocks[block].faces, onSide);
    });
}

/// Earlier position of the point of a block that is now at `place`.
Point placeAtFreezing(const BlockState& before, const BlockState& now, const Point& place) {
    const Eigen::Rotation2Dd turn(before.rotation - now.rotation);
    return before.centroid + turn * Point(place - now.centroid);
}

/// A point well inside the polygon: the middle of the longest part of the horizontal line through the centroid.
Point pointInside(const std::vector<Point>& polygon) {
    const Box box = boxOf(polygon);
    const double level = moments(polygon).centroid.y(), tolerance = 1e-9 * (box.max - box.min).norm();
    const Point from(box.min.x(), level), to(box.max.x(), level);
    std::pair<double, double> longest{0.0, 0.0};
    for (const auto& part : insideIntervals(polygon, from, to, tolerance))
        if (part.second - part.first > longest.second - longest.first) longest = part;
    return from + 0.5 * (longest.first + longest.second) * (to - from);
}

/// The point itself or, if it is outside, the nearest point of the outline. A face plate lies on a face, and faces
/// move.
Point withinOutline(const std::vector<Point>& polygon, const Point& place) {
    if (locate(polygon, place, 0.0) != Side::Outside) return place;
    Point nearest = place;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Point &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        const Point foot = a + std::clamp(footParameter(a, b, place), 0.0, 1.0) * (b - a);
        if ((foot - place).norm() >= least) continue;
        least = (foot - place).norm();
        nearest = foot;
    }
    return nearest;
}

class Freezer {
public:
    explicit Freezer(const Scene& cut) : cut_(cut), solved_(solvedBlocks(cut)) {
        for (std::size_t block = 0; block < cut.blocks.size(); ++block) held_.push_back(isHeld(cut, block));
    }

    /// Forces of bolts and their face plates on free rock at the end of a stage.
    std::vector<FrozenForce> forcesAt(const StageFrames& stage) const {
        std::vector<FrozenForce> list;
        for (const BlockForce& force : blockForces(stage.last))
            if (isOfBolt(force) && !held_[rockOf(force.block)]) list.push_back(frozen(force, stage));
        return list;
    }

private:
    int rocks() const { return solved_.firstOf.back(); }
    std::size_t rockOf(int row) const {
        return solved_.blocks[row].block;
    }

    /// A face plate that is a block of its own touches the rock like any other block.
    bool isOfBolt(const BlockForce& force) const {
        const bool ofPlate = force.source == ForceSource::Contact && force.other >= rocks();
        return force.block < rocks() && (force.source == ForceSource::Bolt || ofPlate);
    }

    FrozenForce frozen(const BlockForce& force, const StageFrames& stage) const {
        const std::size_t row = force.block;
        const BlockState &before = stage.first.blocks[row], &now = stage.last.blocks[row];
        const Point at = placeAtFreezing(before, now, force.position);
        return {force.block, pointInside(before.points), withinOutline(cut_.blocks[rockOf(force.block)].points, at),
                force.force};
    }

    const Scene& cut_;
    SolvedBlocks solved_;
    std::vector<char> held_;  // per block of the scene: true if it is fixed
};

void addLoads(const std::vector<FrozenForce>& forces, const Table& table, const Frame& now, Stage& stage) {
    for (const FrozenForce& force : forces) {
        if (now.blocks[force.row].area == 0.0) continue;  // excavated
        Load load;
        load.blockAt = force.blockAt;
        load.at = force.at;
        load.force = force.force;
        load.table = table;
        stage.loads.push_back(load);
    }
}

/// Gravity and changes of strength act from the start of a stage, so the forces that resist them must act from then on.
const Change& changeIn(const Scene& scene, std::size_t stage) {
    return stage == 0 || !scene.stages[stage].set.empty() ? atStart : gradual;
}

/// \param cut the scene after cutting, which also has the bolts of patterns by name.
bool namesBolt(const std::string& quantity, const Scene& cut) {
    const std::optional<Quantity> read = readQuantity(quantity, cut).quantity;
    if (!read) return false;
    return read->subject.bolt >= 0 || cut.monitors[read->subject.monitor].bolt.has_value();
}

void dropBolts(Scene& scene, const Scene& cut) {
    scene.bolts.clear();
    scene.boltPatterns.clear();
    for (Stage& stage : scene.stages) {
        stage.install.clear();
        stage.remove.clear();
    }
    std::erase_if(scene.quantities, [&](const std::string& text) { return namesBolt(text, cut); });
    std::erase_if(scene.about.expected, [&](const Expected& one) { return namesBolt(one.quantity, cut); });
    std::erase_if(scene.monitors, [](const Monitor& monitor) { return monitor.bolt.has_value(); });
}

}  // namespace

Scene withFrozenBolts(const Scene& scene, const std::vector<StageFrames>& run) {
    const SceneCut cut = cutScene(scene);
    const Freezer freezer(cut.scene);
    Scene frozen = scene;
    dropBolts(frozen, cut.scene);
    std::vector<FrozenForce> before;
    for (std::size_t i = 0; i < run.size(); ++i) {
        const std::vector<FrozenForce> now = freezer.forcesAt(run[i]);
        const Change& change = changeIn(scene, i);
        addLoads(before, change.before, run[i].last, frozen.stages[i]);
        addLoads(now, change.after, run[i].last, frozen.stages[i]);
        before = now;
    }
    return frozen;
}

}  // namespace keyblock
