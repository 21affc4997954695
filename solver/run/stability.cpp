// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/run/stability.h"

#include "solver/engine/bolt/topology.h"
#include "solver/run/failure_mode.h"
#include "solver/scene/deciding.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace keyblock {
namespace {

// fraction of a displaced block's movement: a block joined to it that moved as far is named with it
constexpr double asFar = 0.9;
constexpr double itsOwnWay =
    0.5;  // fraction of a neighbour's movement or velocity; a block with less was left behind by it
// fraction of a block's size: a block that a collapse has moved this far is named even if it is at rest now
constexpr double namedMove = 0.05;
constexpr double slow = 0.02;  // [m/s]; a block that moves faster at the end of a dynamic stage may be unstable
constexpr double touching = 10.0;  // times the geometric tolerance

std::size_t at(int row) { return row; }

bool touches(const Model& model, const Contact& c) {
    return c.bonded || c.normalForce > 0.0 || c.gap - c.gapOffset <= touching * model.tolerance;
}

/// Position to which a body has carried a point that was at `place` at the start.
Point carriedBy(const BlockMotion& before, const BlockMotion& now, const Point& place) {
    return now.centroid + Eigen::Rotation2Dd(now.angle - before.angle) * Point(place - before.centroid);
}

}  // namespace

StageStart startOfStage(const Model& model, const State& state) {
    StageStart start;
    start.blocks = state.blocks;
    for (const Contact& c : state.contacts)
        if (touches(model, c) && !sameRock(model, c.blockA, c.blockB)) start.joined.push_back(std::minmax(c.blockA, c.blockB));
    for (const BoltMotion& bolt : state.bolts)
        for (std::size_t slot = 1; acts(bolt) && slot < bolt.slots.size(); ++slot)
            start.joined.push_back(std::minmax(bolt.slots[slot - 1].block, bolt.slots[slot].block));
    std::sort(start.joined.begin(), start.joined.end());
    start.joined.erase(std::unique(start.joined.begin(), start.joined.end()), start.joined.end());
    return start;
}

void mark(StageStart& start, const State& state, double time, double duration) {
    const auto take = [&](BlockPositions& mark, double share) {
        if (!mark.centroids.empty() || time < share * duration) return;
        mark.time = time;
        for (const BlockMotion& block : state.blocks) mark.centroids.push_back(block.centroid);
    };
    take(start.eight, 0.8);
    take(start.nine, 0.9);
}

Stability::Stability(const Model& model, const StageStart& start, const State& state, const Stage& stage,
                     const Loads& loads)
    : model_(model), start_(start), state_(state), stage_(stage), smallest_(smallestOf(stage)), exempt_(model.blocks.size(), 0),
      neighbours_(model.blocks.size()) {
    for (const auto& [a, b] : start.joined) {
        neighbours_[at(wholeOf(model, a))].push_back({a, b});
        neighbours_[at(wholeOf(model, b))].push_back({b, a});
    }
    exemptDriven(loads);
}

/// Exempts blocks that a motion or a dilation drives, and all blocks joined to them without a fixed block in between.
void Stability::exemptDriven(const Loads& loads) {
    std::vector<int> driven;
    const auto exempt = [&](int row) {
        const int first = wholeOf(model_, row);
        if (exempt_[at(first)] || model_.blocks[at(first)].fixed) return;
        exempt_[at(first)] = 1;
        driven.push_back(first);
    };
    for (const PrescribedMotion& motion : loads.motions) exempt(motion.block);
    for (const Contact& c : state_.contacts)
        if (!stage_.dilations.empty() && c.dilation > 0.0) exempt(c.blockA), exempt(c.blockB);
    while (!driven.empty()) {
        const int first = driven.back();
        driven.pop_back();
        for (const auto& [own, other] : neighbours_[at(first)]) exempt(other);
    }
}

bool Stability::decides(int first) const {
    const BlockModel& block = model_.blocks[at(first)];
    return wholeOf(model_, first) == first && block.plateOf < 0 && !block.fixed && !state_.blocks[at(first)].absent &&
           !exempt_[at(first)] && wholeArea(model_, first) >= smallest_;
}

/// Distance from the middle of a block to its farthest corner [m].
double Stability::reach(int first) const {
    const auto begin = start_.blocks.begin() + first, end = start_.blocks.begin() + endOfWhole(model_, first);
    const Point middle = std::accumulate(begin, end, Point(0.0, 0.0), [](const Point& sum, const BlockMotion& b) -> Point {
                             return sum + b.centroid;
                         }) / static_cast<double>(end - begin);
    double farthest = 0.0;
    for (auto block = begin; block != end; ++block)
        for (const Point& corner : block->corners) farthest = std::max(farthest, (corner - middle).norm());
    return farthest;
}

/// Largest distance of a corner from the position to which `other` would have carried it [m].
double Stability::movedFrom(int row, int other) const {
    double farthest = 0.0;
    const BlockMotion &before = start_.blocks[at(row)], &now = state_.blocks[at(row)];
    for (std::size_t i = 0; i < std::min(before.corners.size(), now.corners.size()); ++i)
        farthest = std::max(farthest, (now.corners[i] - carriedBy(start_.blocks[at(other)], state_.blocks[at(other)],
                                                                  before.corners[i])).norm());
    return farthest;
}

/// Largest displacement of a corner [m].
double Stability::movedItself(int first) const {
    double farthest = 0.0;
    for (int row = first; row < endOfWhole(model_, first); ++row) {
        const BlockMotion &before = start_.blocks[at(row)], &now = state_.blocks[at(row)];
        for (std::size_t i = 0; i < std::min(before.corners.size(), now.corners.size()); ++i)
            farthest = std::max(farthest, (now.corners[i] - before.corners[i]).norm());
    }
    return farthest;
}

/// Movement relative to the blocks that it touched or was bolted to, except those that moved away from it; the full
/// movement if it touched none [m].
double Stability::moved(int first) const {
    const double itself = movedItself(first);
    if (neighbours_[at(first)].empty()) return itself;
    double farthest = 0.0;
    for (const auto& [own, other] : neighbours_[at(first)]) {
        const int whole = wholeOf(model_, other);
        if (state_.blocks[at(other)].absent || model_.blocks[at(other)].plateOf >= 0) continue;
        if (itself >= itsOwnWay * movedItself(whole)) farthest = std::max(farthest, movedFrom(own, other));
    }
    return farthest;
}

UnstableBlock Stability::describe(int first) const {
    const BlockMotion &before = start_.blocks[at(first)], &now = state_.blocks[at(first)];
    double mass = 0.0;
    for (int row = first; row < endOfWhole(model_, first); ++row) mass += model_.blocks[at(row)].mass;
    return {first,
            movementOf(now.centroid - before.centroid, now.angle - before.angle, reach(first), model_.gravity),
            moved(first), mass * model_.gravity.norm()};
}

std::vector<UnstableBlock> Stability::describeAll(const std::vector<int>& blocks) const {
    std::vector<UnstableBlock> unstable;
    for (const int first : blocks) unstable.push_back(describe(first));
    return unstable;
}

std::vector<UnstableBlock> Stability::collapsed(const std::vector<int>& blocks, const std::vector<int>& followers) const {
    std::vector<UnstableBlock> unstable = describeAll(blocks);
    const auto isNamed = [&](int first) {
        return std::any_of(unstable.begin(), unstable.end(), [&](const UnstableBlock& one) { return one.block == first; });
    };
    const auto addFollower = [&](int first) {
        if (isNamed(first)) return;
        unstable.push_back(describe(first));
        unstable.back().mode = Movement::Follows;
    };
    for (const int first : followers) addFollower(first);
    for (const int first : displacedBlocks(namedMove)) addFollower(first);
    return unstable;
}

std::vector<UnstableBlock> Stability::displaced(double share) const {
    return describeAll(displacedBlocks(share));
}

std::vector<int> Stability::displacedBlocks(double share) const {
    std::vector<int> left;
    std::vector<char> named(model_.blocks.size(), 0);
    for (int first = 0; first < static_cast<int>(model_.blocks.size()); ++first)
        if (decides(first) && moved(first) > share * reach(first)) left.push_back(first), named[at(first)] = 1;
    for (std::size_t next = 0; next < left.size(); ++next) {
        const double least = asFar * movedItself(left[next]);
        for (const auto& [own, other] : neighbours_[at(left[next])]) {
            const int whole = wholeOf(model_, other);
            if (named[at(whole)] || !decides(whole) || movedItself(whole) < least) continue;
            named[at(whole)] = 1;
            left.push_back(whole);
        }
    }
    std::sort(left.begin(), left.end());
    return left;
}

Point Stability::velocity(int row) const {
    const BlockMotion& block = state_.blocks[at(row)];
    return block.velocity[0] * block.axis + block.velocity[1] * turnLeft(block.axis);
}

/// Per first row: largest velocity relative to the blocks that it touches now, except those that move away from it; its
/// own velocity if it touches none [m/s].
std::vector<double> Stability::speeds() const {
    std::vector<double> fastest(model_.blocks.size(), 0.0);
    std::vector<char> alone(model_.blocks.size(), 1);
    const auto take = [&](int row, int otherRow) {
        const std::size_t first = at(wholeOf(model_, row));
        alone[first] = 0;
        const Point own = velocity(row), other = velocity(otherRow);
        if (own.norm() >= itsOwnWay * other.norm()) fastest[first] = std::max(fastest[first], (own - other).norm());
    };
    for (const Contact& c : state_.contacts) {
        if (wholeOf(model_, c.blockA) == wholeOf(model_, c.blockB) || !touches(model_, c)) continue;
        take(c.blockA, c.blockB);
        take(c.blockB, c.blockA);
    }
    for (std::size_t i = 0; i < fastest.size(); ++i)
        if (alone[i]) fastest[i] = velocity(static_cast<int>(i)).norm();
    return fastest;
}

/// True if it moved at least as fast in the last tenth of the stage as in the tenth before.
bool Stability::keepsItsSpeed(int first) const {
    if (start_.nine.centroids.empty() || start_.nine.time <= start_.eight.time) return true;
    const Point &eight = start_.eight.centroids[at(first)], &nine = start_.nine.centroids[at(first)];
    const double before = (nine - eight).norm() / (start_.nine.time - start_.eight.time);
    const double last = (state_.blocks[at(first)].centroid - nine).norm();
    return last >= before * (stage_.duration - start_.nine.time);
}

std::vector<UnstableBlock> Stability::moving(bool continued) const {
    std::vector<int> blocks;
    const std::vector<double> speed = speeds();
    for (int first = 0; first < static_cast<int>(model_.blocks.size()); ++first) {
        if (!decides(first)) continue;
        const bool fell = state_.blocks[at(first)].fallen && !start_.blocks[at(first)].fallen;
        const bool goesOn = !continued && speed[at(first)] > slow && keepsItsSpeed(first);
        if (fell || moved(first) > reach(first) || goesOn) blocks.push_back(first);
    }
    return describeAll(blocks);
}

UnstableBlock Stability::farthest() const {
    int farthest = -1;
    double most = -1.0;
    for (int first = 0; first < static_cast<int>(model_.blocks.size()); ++first) {
        if (!decides(first)) continue;
        const double share = moved(first) / reach(first);
        if (share > most) most = share, farthest = first;
    }
    return farthest < 0 ? UnstableBlock{} : describe(farthest);
}

std::vector<int> Stability::loose() const {
    std::vector<int> pieces;
    for (int first = 0; first < static_cast<int>(model_.blocks.size()); ++first)
        if (wholeOf(model_, first) == first && state_.blocks[at(first)].absent && !start_.blocks[at(first)].absent &&
            model_.blocks[at(first)].plateOf < 0)
            pieces.push_back(first);
    return pieces;
}

}  // namespace keyblock
