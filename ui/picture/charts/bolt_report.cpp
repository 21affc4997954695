// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/picture/charts/bolt_report.h"

#include <algorithm>
#include <array>
#include <cassert>

namespace keyblock {

namespace {

constexpr std::array<std::string_view, 9> conditionWords{
    "not installed", "intact",   "partly debonded", "debonded", "yielded",
    "face plate lost", "ruptured", "pulled out",      "lost"};

/// Tributary length of a node [m]: half of the distance to each neighbour.
double lengthOf(const std::vector<BoltNodeFrame>& nodes, std::size_t node) {
    const double from = node > 0 ? nodes[node - 1].s : nodes[node].s;
    const double to = node + 1 < nodes.size() ? nodes[node + 1].s : nodes[node].s;
    return 0.5 * (to - from);
}

void countNodes(const std::vector<BoltNodeFrame>& nodes, BoltReport& report) {
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (!nodes[i].real) continue;
        const bool slips = nodes[i].state == NodeState::Slipping, gone = nodes[i].state == NodeState::Gone;
        report.bonded += nodes[i].state == NodeState::Bonded;
        report.slipping += slips;
        report.failed += gone;
        if (slips || gone) report.debonded += lengthOf(nodes, i);
    }
}

BoltCondition conditionOf(const BoltFrame& frame, const BoltReport& report, int bolt, std::span<const Event> events) {
    const auto had = [&](EventKind kind) {
        return std::ranges::any_of(events, [&](const Event& event) { return event.bolt == bolt && event.kind == kind; });
    };
    if (frame.lost) return BoltCondition::Lost;
    if (had(EventKind::PulledOut)) return BoltCondition::PulledOut;
    if (std::ranges::any_of(frame.nodes, &BoltNodeFrame::ruptured)) return BoltCondition::Ruptured;
    if (report.hasPlate && !report.plateHolds && had(EventKind::PlateLoss)) return BoltCondition::PlateLost;
    if (had(EventKind::Yield) || had(EventKind::Hinge)) return BoltCondition::Yielded;
    if (report.slipping + report.failed == 0) return BoltCondition::Intact;
    return report.bonded > 0 ? BoltCondition::PartlyDebonded : BoltCondition::Debonded;
}

}  // namespace

std::string_view wordOf(BoltCondition condition) { return conditionWords[static_cast<std::size_t>(condition)]; }

BoltReport boltReport(const Scene& scene, const Frame& frame, int bolt, std::span<const Event> events) {
    const std::size_t row = bolt;
    assert(bolt >= 0 && row < scene.bolts.size() && row < frame.bolts.size());
    const BoltFrame& state = frame.bolts[row];
    BoltReport report;
    report.use = boltUse(bolt, row < frame.extremes.size() ? frame.extremes[row] : BoltExtremes{});
    report.hasPlate = scene.bolts[row].plate != PlateKind::None;
    if (state.nodes.empty()) return report;
    report.plateHolds = state.plateHolds;
    report.plateForce = state.nodes.back().axialForce;
    countNodes(state.nodes, report);
    report.condition = conditionOf(state, report, bolt, events);
    return report;
}

}  // namespace keyblock
