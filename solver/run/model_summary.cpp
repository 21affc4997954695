// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// All parts of the scene are counted as if they were active at the same time,
// whichever stage adds or removes them: this is the largest system that a step can
// have.
#include "solver/run/model_summary.h"

#include "solver/engine/bolt/topology.h"
#include "solver/engine/contact/search.h"
#include "solver/engine/setup/make_model.h"

#include <algorithm>
#include <cassert>

namespace keyblock {
namespace {

State startWithAll(const Model& model) {
    State start = makeState(model);
    start.contacts = findContacts(model, start.blocks, {}, model.size * 1e-3, true);
    placeBolts(model, start);
    return start;
}

}  // namespace

ModelCounts countParts(const Model& model, const State& start) {
    ModelCounts counts;
    for (const BlockModel& block : model.blocks) {
        const bool plate = block.plateOf >= 0;
        ++(plate ? counts.plates : counts.blocks);
        counts.cells += block.cell ? 1 : 0;
        counts.fixed += block.fixed ? 1 : 0;
        if (!block.fixed) (plate ? counts.plateUnknowns : counts.blockUnknowns) += 6;
    }
    for (const BoltModel& bolt : model.bolts) {
        const int nodes = static_cast<int>(bolt.s.size());
        counts.nodes += nodes;
        counts.boltUnknowns += (bolt.bends ? 3 : 2) * nodes;
        counts.realAnchors += static_cast<int>(
            std::count_if(bolt.anchors.begin(), bolt.anchors.end(), [](const AnchorModel& a) { return a.real; }));
    }
    counts.bolts = static_cast<int>(model.bolts.size());
    counts.heldPoints = static_cast<int>(model.supports.size());
    counts.contacts = static_cast<int>(start.contacts.size());
    counts.gluedEdges = static_cast<int>(model.glue.size());
    return counts;
}

std::optional<ModelSummary> makeModelSummary(const Scene& scene, const SceneCut* cut, const std::atomic<bool>* stop) {
    assert(!scene.blocks.empty());
    const Model model = makeModel(scene);
    if (stop && *stop) return std::nullopt;
    const State start = startWithAll(model);
    ModelSummary summary;
    summary.counts = countParts(model, start);
    summary.leftOut = leftOutOf(scene, cut, model, summary.counts);
    summary.next = nextLeftOut(scene, model);
    std::optional<CostEstimate> estimate = estimateCost(scene, model, start, summary.counts, stop);
    if (!estimate) return std::nullopt;
    summary.estimate = std::move(*estimate);
    return summary;
}

}  // namespace keyblock
