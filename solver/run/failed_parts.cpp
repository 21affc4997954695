// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/run/failed_parts.h"

#include "solver/results/bolt_use.h"
#include "solver/run/failure_mode.h"
#include "solver/scene/solved_blocks.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace keyblock {

namespace {

// fraction of the largest joint movement of a block: smaller movements are not reported
constexpr double leastShare = 0.1;

/// The joints and bolts that fail in one stage.
class StageFailure {
public:
    StageFailure(const RunSource& run, const SolvedBlocks& solved, int stage, const Verdict& verdict)
        : run_(run), solved_(solved), stage_(stage), moves_(solved.blocks.size(), 0) {
        for (const StageUnstable& one : verdict.blocks)
            if (one.stage == stage) addBlock(one.block.block);
        for (std::size_t i = 0; i < run.frames().size(); ++i) {
            if (run.frames()[i].stage != stage) continue;
            if (!first_) first_ = i;
            last_ = i;
        }
    }

    void addTo(FailedParts& parts) const {
        if (!first_) return;
        const Frame after = run_.frame(last_);
        addJoints(after, parts.joints);
        addBolts(after, parts.bolts);
    }

private:
    /// Adds a block with all its cells.
    void addBlock(int first) {
        const int block = solved_.blocks[first].block;
        for (std::size_t row = 0; row < moves_.size(); ++row)
            if (solved_.blocks[row].block == block && solved_.blocks[row].plateOf < 0) moves_[row] = 1;
    }

    int firstRow(int row) const {
        return solved_.firstOf[solved_.blocks[row].block];
    }

    bool moves(int row) const { return moves_[row] != 0; }

    void addJoints(const Frame& after, std::vector<FailedJoint>& joints) const {
        std::vector<int> rows;
        for (int row = 0; row < static_cast<int>(moves_.size()); ++row)
            if (moves(row)) rows.push_back(row);
        std::map<std::pair<int, int>, FailedJoint> found;
        std::map<int, double> largest;  // per block: largest movement of its joints
        for (const MovingJoint& joint : jointsAround(run_.frame(*first_), after, rows)) {
            if (solved_.blocks[joint.blockB].plateOf >= 0) continue;
            FailedJoint& one = found[{firstRow(joint.blockA), firstRow(joint.blockB)}];
            if (std::hypot(joint.slip, joint.opening) > std::hypot(one.slip, one.opening)) one.position = joint.position;
            one.slip = std::max(one.slip, joint.slip);
            one.opening = std::max(one.opening, joint.opening);
            double& most = largest[firstRow(joint.blockA)];
            most = std::max(most, std::hypot(one.slip, one.opening));
        }
        for (auto& [pair, joint] : found) {
            const double movement = std::hypot(joint.slip, joint.opening);
            if (movement == 0.0 || movement < leastShare * largest[pair.first]) continue;
            joint.stage = stage_;
            joint.blockA = pair.first;
            joint.blockB = pair.second;
            joint.opened = joint.opening >= joint.slip;
            joints.push_back(joint);
        }
    }

    void addBolts(const Frame& after, std::vector<FailedBolt>& bolts) const {
        const auto installed = boltsAsInstalled(run_);
        std::vector<Event> events = run_.events();
        std::erase_if(events, [&](const Event& event) { return event.stage > stage_ || event.bolt < 0; });
        for (int b = 0; b < static_cast<int>(installed.size()); ++b) {
            const std::vector<BoltNodeFrame>& nodes = installed[b];
            const auto isIn = [&](bool moving) {
                return std::ranges::any_of(nodes, [&](const BoltNodeFrame& node) {
                    return node.block >= 0 && moves(node.block) == moving;
                });
            };
            if (!isIn(true) || !isIn(false)) continue;
            for (const EventKindRow& row : eventKinds) {
                if (!isGrave(row.kind)) continue;
                const auto event = std::ranges::find_if(
                    events, [&](const Event& e) { return e.bolt == b && e.kind == row.kind; });
                if (event != events.end()) bolts.push_back({b, row.kind, event->stage, event->time});
            }
            const bool plate = after.bolts[b].plateHolds;
            for (const bool moving : {true, false})
                if (const Event* last = debonded(b, nodes, moving, plate, events)) {
                    bolts.push_back({b, EventKind::Debonding, last->stage, last->time});
                    break;
                }
        }
    }

    /// The last of the events in which the bonds on one side of a bolt failed. Null if one of them is intact, if there
    /// are none, or if the face plate supports that side.
    const Event* debonded(int bolt, const std::vector<BoltNodeFrame>& nodes, bool moving, bool plateHolds,
                          const std::vector<Event>& events) const {
        const Event* last = nullptr;
        int head = -1;  // block nearest to the head
        for (std::size_t n = 0; n < nodes.size(); ++n) {
            if (nodes[n].block < 0) continue;
            head = nodes[n].block;
            if (!nodes[n].real || moves(nodes[n].block) != moving) continue;
            const auto event = std::ranges::find_if(events, [&](const Event& e) {
                return e.bolt == bolt && e.kind == EventKind::Debonding && e.node == static_cast<int>(n);
            });
            if (event == events.end()) return nullptr;
            if (!last || std::pair(event->stage, event->time) > std::pair(last->stage, last->time)) last = &*event;
        }
        return head >= 0 && plateHolds && moves(head) == moving ? nullptr : last;
    }

    const RunSource& run_;
    const SolvedBlocks& solved_;
    int stage_;
    std::vector<char> moves_;  // per solved block: true if the verdict lists it
    std::optional<std::size_t> first_;  // first frame of the stage
    std::size_t last_ = 0;
};

}  // namespace

FailedParts failedParts(const RunSource& run, const Verdict& verdict) {
    FailedParts parts;
    if (verdict.blocks.empty()) return parts;
    const SolvedBlocks solved = solvedBlocks(run.scene());
    std::vector<int> stages;
    for (const StageUnstable& one : verdict.blocks)
        if (std::ranges::find(stages, one.stage) == stages.end()) stages.push_back(one.stage);
    for (const int stage : stages) StageFailure(run, solved, stage, verdict).addTo(parts);
    return parts;
}

}  // namespace keyblock
