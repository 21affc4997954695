// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/results/bolt_design.h"

#include "solver/results/block_forces.h"
#include "solver/scene/bolt_steel.h"
#include "solver/scene/lookup.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace keyblock {

namespace {

constexpr std::array<std::string_view, 10> statusWords{"not-installed", "removed",    "lost",     "ruptured",
                                                       "pulled-out",    "plate-lost", "debonded", "partly-debonded",
                                                       "yielded",       "intact"};

/// Length of bolt that belongs to each node [m].
std::vector<double> tributaryLengths(const std::vector<BoltNodeFrame>& nodes) {
    std::vector<double> lengths(nodes.size(), 0.0);
    for (std::size_t n = 1; n < nodes.size(); ++n) {
        const double half = 0.5 * (nodes[n].s - nodes[n - 1].s);
        lengths[n - 1] += half;
        lengths[n] += half;
    }
    return lengths;
}

void takeLarger(double& largest, double value) {
    if (std::abs(value) > std::abs(largest)) largest = value;
}

BoltForcesNow forcesNow(const std::vector<BoltNodeFrame>& nodes) {
    BoltForcesNow now;
    for (std::size_t n = 0; n < nodes.size(); ++n) {
        takeLarger(now.moment, nodes[n].moment);
        if (n + 1 == nodes.size()) continue;
        takeLarger(now.axial, nodes[n].axialForce);
        takeLarger(now.shear, nodes[n].shearForce);
    }
    if (!nodes.empty()) {
        now.plateNormal = nodes.back().axialForce;
        now.plateShear = nodes.back().shearForce;
    }
    return now;
}

/// What the design of all bolts in one frame needs.
class Designer {
public:
    Designer(const RunSource& run, std::size_t frame)
        : run_(run), frame_(run.frame(frame)), events_(run.events()), solved_(solvedBlocks(run.scene())),
          installed_(boltsAsInstalled(run)), carried_(carriedBlocks(netForces(solved_, frame_))) {
        events_.resize(std::min(events_.size(), static_cast<std::size_t>(std::max(0L, frame_.events))));
        findInstallations();
    }

    std::vector<BoltDesign> all() const {
        std::vector<BoltDesign> designs;
        const std::vector<BoltUse> uses = boltUses(run_);
        for (std::size_t b = 0; b < std::min(uses.size(), frame_.extremes.size()); ++b)
            designs.push_back(designOf(b, uses[b].holds));
        return designs;
    }

private:
    /// Bolts are installed at the start of a stage, so the first frame of each stage shows them.
    void findInstallations() {
        stages_.assign(installed_.size(), -1);
        int stage = -1;
        for (std::size_t i = 0; i < run_.frames().size(); ++i) {
            if (run_.frames()[i].stage == stage) continue;
            if (std::ranges::none_of(stages_, [](int known) { return known < 0; })) break;
            stage = run_.frames()[i].stage;
            const Frame frame = run_.frame(i);
            for (std::size_t b = 0; b < stages_.size(); ++b)
                if (stages_[b] < 0 && !frame.bolts[b].nodes.empty()) stages_[b] = stage;
        }
    }

    BoltDesign designOf(std::size_t b, const std::vector<int>& holds) const {
        BoltDesign design;
        design.use = boltUse(static_cast<int>(b), frame_.extremes[b]);
        design.use.holds = holds;
        design.state = frame_.bolts[b];
        addYield(run_.scene().bolts[b], design);
        design.now = forcesNow(design.state.nodes);
        addLengths(installed_[b], design);
        design.carries = carried_[b];
        design.since = since(stages_[b], design.carries);
        design.status = statusOf(b, design);
        return design;
    }

    /// Steel is stronger in dynamic stages by the bolt's factor, as in `run`.
    void addYield(const Bolt& bolt, BoltDesign& design) const {
        const BoltType& type = boltTypeOf(run_.scene(), bolt);
        const BoltPeak& peak = design.use.extremes.axialForce;
        design.yieldForce = boltSteel(type).yield;
        if (!design.yieldForce) return;
        if (peak.stage >= 0 && run_.scene().stages[peak.stage].kind == StageKind::Dynamic)
            *design.yieldForce *= bolt.steelDynamicFactor.value_or(type.steelDynamicFactor);
        design.yieldUse = std::abs(peak.value) / *design.yieldForce;
    }

    void addLengths(const std::vector<BoltNodeFrame>& before, BoltDesign& design) const {
        const std::vector<BoltNodeFrame>& now = design.state.nodes;
        const std::vector<double> lengths = tributaryLengths(before);
        for (std::size_t n = 0; n < std::min(before.size(), now.size()); ++n) {
            if (!before[n].real || before[n].state == NodeState::Free) continue;
            design.bondedLength += lengths[n];
            if (now[n].state != NodeState::Bonded) design.debondedLength += lengths[n];
        }
    }

    bool hasEvent(std::size_t bolt, std::initializer_list<EventKind> kinds) const {
        return std::ranges::any_of(events_, [&](const Event& event) {
            return event.bolt == static_cast<int>(bolt) && std::ranges::count(kinds, event.kind) > 0;
        });
    }

    BoltStatus statusOf(std::size_t b, const BoltDesign& design) const {
        const BoltFrame& now = design.state;
        if (now.nodes.empty()) return installed_[b].empty() ? BoltStatus::NotInstalled : BoltStatus::Removed;
        if (now.lost) return BoltStatus::Lost;
        if (std::ranges::any_of(now.nodes, &BoltNodeFrame::ruptured)) return BoltStatus::Ruptured;
        if (hasEvent(b, {EventKind::PulledOut})) return BoltStatus::PulledOut;
        if (run_.scene().bolts[b].plate != PlateKind::None && !now.plateHolds) return BoltStatus::PlateLost;
        if (design.debondedLength > 0.0)
            return design.debondedLength < design.bondedLength ? BoltStatus::PartlyDebonded : BoltStatus::Debonded;
        return hasEvent(b, {EventKind::Yield, EventKind::Hinge}) ? BoltStatus::Yielded : BoltStatus::Intact;
    }

    bool isOf(int row, int first) const { return row >= 0 && solved_.firstOf[solved_.blocks[row].block] == first; }

    long firstOf(EventKind kind, int stage, int block) const {
        for (std::size_t i = 0; i < events_.size(); ++i) {
            const Event& event = events_[i];
            if (event.kind == kind && event.stage >= stage &&
                (isOf(event.block, block) || isOf(event.otherBlock, block)))
                return static_cast<long>(i);
        }
        return -1;
    }

    long since(int stage, const std::vector<CarriedBlock>& carries) const {
        if (stage < 0 || carries.empty()) return -1;
        long event = firstOf(EventKind::JointOpen, stage, carries.front().block);
        if (event < 0) event = firstOf(EventKind::JointSlip, stage, carries.front().block);
        while (event >= 0 && events_[event].cause >= 0 && events_[event].cause < event) event = events_[event].cause;
        return event;
    }

    const RunSource& run_;
    Frame frame_;
    std::vector<Event> events_;  // up to the frame
    SolvedBlocks solved_;
    std::vector<std::vector<BoltNodeFrame>> installed_;
    std::vector<int> stages_;  // per bolt: stage in which it was installed; −1: not yet
    std::vector<std::vector<CarriedBlock>> carried_;
};

}  // namespace

std::string_view wordOf(BoltStatus status) { return statusWords.at(static_cast<std::size_t>(status)); }

std::vector<BoltDesign> boltDesigns(const RunSource& run, std::size_t frame) { return Designer(run, frame).all(); }

NetForces netForces(const SolvedBlocks& solved, const Frame& frame) {
    NetForces net;
    net.bolts.resize(frame.bolts.size());
    for (const BlockForce& force : blockForces(frame)) {
        const SolvedBlock& block = solved.blocks[force.block];
        const int first = solved.firstOf[block.block];
        const auto add = [&](std::map<int, Point>& sums) {
            sums.try_emplace(first, 0.0, 0.0).first->second += force.force;
        };
        if (force.source == ForceSource::Weight && block.plateOf < 0) add(net.weights);
        if (force.source == ForceSource::Bolt) add(net.bolts[force.other]);
    }
    return net;
}

std::vector<std::vector<CarriedBlock>> carriedBlocks(const NetForces& forces) {
    std::vector<std::vector<CarriedBlock>> carried;
    for (const std::map<int, Point>& ofBolt : forces.bolts) {
        std::vector<CarriedBlock>& blocks = carried.emplace_back();
        for (const auto& [block, force] : ofBolt) {
            const auto weight = forces.weights.find(block);
            if (weight == forces.weights.end() || weight->second.isZero(0.0)) continue;
            const double size = weight->second.norm(), against = -force.dot(weight->second / size);
            if (against >= leastCarriedShare * size) blocks.push_back({block, size, against});
        }
        std::ranges::stable_sort(blocks, std::ranges::greater{}, &CarriedBlock::force);
    }
    return carried;
}

}  // namespace keyblock
