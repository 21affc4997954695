// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/results/run_comparison.h"

#include "geometry/polygon.h"
#include "solver/results/bolt_design.h"
#include "solver/results/settled_blocks.h"
#include "solver/scene/lookup.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <span>
#include <utility>

namespace keyblock {

namespace {

constexpr double sameOutline =
    1e-6;  // largest difference of centroids, as a fraction of the scene's size, and of areas

struct Outline {
    int block = -1;  // index in the scene
    Point centroid{0.0, 0.0};
    double area = 0.0;
};

/// Outlines of all blocks as drawn, by the x of their centroids.
std::vector<Outline> outlinesOf(const Scene& scene) {
    std::vector<Outline> outlines;
    for (std::size_t i = 0; i < scene.blocks.size(); ++i) {
        const std::vector<Point>& points = scene.blocks[i].points;
        outlines.push_back({static_cast<int>(i), moments(points).centroid, moments(points).area});
    }
    std::ranges::sort(outlines, {}, [](const Outline& o) { return o.centroid.x(); });
    return outlines;
}

/// A run at its end, with what the comparison reads from it.
struct ComparedRun {
    const RunSource& run;
    SolvedBlocks solved;
    Frame last;  // without blocks for a run without frames
    NetForces forces;
    Verdict verdict;
    std::vector<int> settled;
    std::vector<BoltUse> uses;

    explicit ComparedRun(const RunSource& source)
        : run(source), solved(solvedBlocks(source.scene())), verdict(verdictOf(source.stages(), source.scene())),
          settled(settledBlocks(source, verdict)), uses(boltUses(source)) {
        if (run.frames().empty()) return;
        last = run.frame(run.frames().size() - 1);
        forces = netForces(solved, last);
    }

    int firstOf(int row) const { return solved.firstOf[solved.blocks[row].block]; }

    bool falls(int first) const {
        const bool listed = std::ranges::any_of(verdict.blocks,
                                                [&](const StageUnstable& one) { return one.block.block == first; });
        return listed && std::ranges::count(settled, first) == 0;
    }

    bool isPresent(int first) const {
        return !last.blocks.empty() && wholeDisplacement(run.scene(), solved, last, first).has_value();
    }

    /// Displacement of the centroid of a block since the start of the run. \pre the block is present.
    Point moved(int first) const { return wholeDisplacement(run.scene(), solved, last, first).value(); }
};

std::vector<SharedBlock> sharedBlocks(const ComparedRun& a, const ComparedRun& b) {
    const double size = std::max(sceneSize(a.run.scene()), sceneSize(b.run.scene()));
    const std::vector<Outline> others = outlinesOf(b.run.scene());
    std::vector<char> taken(others.size(), 0);
    std::vector<SharedBlock> shared;
    for (const Outline& one : outlinesOf(a.run.scene())) {
        const double near = sameOutline * size;
        auto at = std::ranges::lower_bound(others, one.centroid.x() - near, {},
                                           [](const Outline& o) { return o.centroid.x(); });
        for (; at != others.end() && at->centroid.x() <= one.centroid.x() + near; ++at) {
            char& used = taken[at - others.begin()];
            const bool same = (at->centroid - one.centroid).norm() <= near &&
                              std::abs(at->area - one.area) <= sameOutline * std::max(at->area, one.area);
            if (used != 0 || !same) continue;
            used = 1;
            shared.push_back({a.solved.firstOf[one.block], b.solved.firstOf[at->block]});
            break;
        }
    }
    std::ranges::sort(shared, {}, &SharedBlock::a);
    return shared;
}

/// Finds the bolts that hold in one run the blocks that fall in the other.
class Rescue {
public:
    /// \param fallen pairs of the run in which they fall and the one in which they are stable.
    Rescue(const ComparedRun& falling, const ComparedRun& stable, const std::vector<std::pair<int, int>>& fallen)
        : stable_(stable) {
        for (const auto& [inFalling, inStable] : fallen) {
            held_[inStable];
            addDirect(inStable, falling.isPresent(inFalling) ? falling.moved(inFalling) : Point(0.0, 0.0));
        }
        spread();
    }

    std::vector<HoldingBolt> of(int block) const { return held_.at(block); }

private:
    /// \param movement of the block where it falls [m]; zero: unknown, taken to be along its weight.
    void addDirect(int block, Point movement) {
        const auto known = stable_.forces.weights.find(block);
        const Point weight = known == stable_.forces.weights.end() ? Point(0.0, 0.0) : known->second;
        if (movement.isZero(0.0)) movement = weight;
        const double length = movement.norm(), least = leastHoldingShare * weight.norm();
        if (length == 0.0) return;
        std::vector<HoldingBolt>& bolts = held_[block];
        for (std::size_t b = 0; b < stable_.forces.bolts.size(); ++b) {
            const auto force = stable_.forces.bolts[b].find(block);
            if (force == stable_.forces.bolts[b].end()) continue;
            const double against = -force->second.dot(movement) / length;
            if (against > 0.0 && against >= least) bolts.push_back({static_cast<int>(b), against, block});
        }
        std::ranges::stable_sort(bolts, std::ranges::greater{}, &HoldingBolt::force);
    }

    /// Blocks without a bolt of their own take the bolts of a block that they touch, step by step.
    void spread() {
        for (bool changed = true; changed;) {
            changed = false;
            std::map<int, std::vector<HoldingBolt>> reached;
            for (const ContactFrame& contact : stable_.last.contacts) {
                const int a = stable_.firstOf(contact.blockA), b = stable_.firstOf(contact.blockB);
                for (const auto& [from, to] : {std::pair(a, b), std::pair(b, a)}) {
                    const auto source = held_.find(from), target = held_.find(to);
                    if (source == held_.end() || target == held_.end() || source->second.empty()) continue;
                    if (target->second.empty()) reached.emplace(to, source->second);
                }
            }
            for (auto& [block, bolts] : reached) {
                held_[block] = std::move(bolts);
                changed = true;
            }
        }
    }

    const ComparedRun& stable_;
    std::map<int, std::vector<HoldingBolt>> held_;  // by block of the stable run
};

/// Blocks that fall in `falling` and are stable in `stable`.
void addSaved(const ComparedRun& falling, const ComparedRun& stable, bool fallsInA, std::span<const SharedBlock> shared,
              std::vector<SavedBlock>& saved) {
    std::vector<std::pair<int, int>> fallen;
    std::vector<SavedBlock> found;
    for (const StageUnstable& fall : falling.verdict.blocks) {
        const auto match = std::ranges::find_if(
            shared, [&](const SharedBlock& s) { return (fallsInA ? s.a : s.b) == fall.block.block; });
        if (match == shared.end() || !falling.falls(fall.block.block)) continue;
        const int other = fallsInA ? match->b : match->a;
        if (stable.falls(other) || !stable.isPresent(other)) continue;
        fallen.emplace_back(fall.block.block, other);
        const bool known = falling.isPresent(fall.block.block);
        found.push_back({*match, fallsInA, fall, known ? falling.moved(fall.block.block).norm() : 0.0, {}});
    }
    const Rescue rescue(falling, stable, fallen);
    for (SavedBlock& one : found) one.heldBy = rescue.of(fallsInA ? one.block.b : one.block.a);
    saved.insert(saved.end(), found.begin(), found.end());
}

std::vector<BlockDifference> blockDifferences(const ComparedRun& a, const ComparedRun& b,
                                              std::span<const SharedBlock> shared) {
    std::vector<BlockDifference> differences;
    for (const SharedBlock& one : shared)
        if (a.isPresent(one.a) && b.isPresent(one.b)) differences.push_back({one, a.moved(one.a), b.moved(one.b)});
    std::ranges::stable_sort(differences, std::ranges::greater{}, &BlockDifference::size);
    return differences;
}

std::vector<BoltDifference> boltDifferences(const ComparedRun& a, const ComparedRun& b) {
    std::vector<BoltDifference> differences;
    for (const BoltUse& use : a.uses) differences.push_back({a.run.scene().bolts[use.bolt].name, use, {}});
    for (const BoltUse& use : b.uses) {
        const std::string& name = b.run.scene().bolts[use.bolt].name;
        const auto same = std::ranges::find(differences, name, &BoltDifference::name);
        if (same != differences.end()) same->b = use;
        else differences.push_back({name, {}, use});
    }
    return differences;
}

}  // namespace

RunComparison compareRuns(const RunSource& a, const RunSource& b) {
    const ComparedRun runA(a), runB(b);
    const std::vector<SharedBlock> shared = sharedBlocks(runA, runB);
    RunComparison result;
    result.a = runA.verdict;
    result.b = runB.verdict;
    result.settledA = runA.settled;
    result.settledB = runB.settled;
    result.shared = shared.size();
    result.onlyA = a.scene().blocks.size() - shared.size();
    result.onlyB = b.scene().blocks.size() - shared.size();
    addSaved(runA, runB, true, shared, result.saved);
    addSaved(runB, runA, false, shared, result.saved);
    result.blocks = blockDifferences(runA, runB, shared);
    result.bolts = boltDifferences(runA, runB);
    return result;
}

}  // namespace keyblock
