// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What will be modelled of a scene and what not, before anything is run: counts,
// what is not needed and therefore left out, and what a run may cost. Only
// what a scene requires is modelled; here the user sees what that is.
#pragma once

#include "solver/engine/model/model.h"
#include "solver/engine/model/state.h"
#include "solver/scene/scene_cut.h"

#include <atomic>
#include <optional>
#include <string>
#include <vector>

namespace keyblock {

struct ModelCounts {
    int blocks = 0;  // bodies of rock: whole blocks, or cells
    int cells = 0;  // of these
    int plates = 0;  // that are blocks of their own
    int fixed = 0;  // of blocks, held whole
    int heldPoints = 0;
    int bolts = 0, nodes = 0;
    int realAnchors = 0;  // of nodes, held along the bolt by the type
    int contacts = 0;  // corners before edges at the start, each with a spring across and one along
    int gluedEdges = 0;
    int blockUnknowns = 0;  // six for each block that is not held whole
    int plateUnknowns = 0;
    int boltUnknowns = 0;  // three a node; two where the type does not bend

    int unknowns() const { return blockUnknowns + plateUnknowns + boltUnknowns; }
};

/// Something that the program could model and does not.
struct LeftOut {
    std::string what;
    std::string why;  // the scene does not need it
    std::string saves;
};

struct StageCost {
    std::string name;
    double steps = 0.0;  // increments, or steps of time
    double passes = 0.0;  // linear systems that are solved
    double least = 0.0, most = 0.0;  // of these, as far as can be known before
};

/// What a run may take.
struct CostEstimate {
    double seconds = 0.0, secondsLeast = 0.0, secondsMost = 0.0;
    double memory = 0.0;  // [bytes] the largest
    double passSeconds = 0.0, stepSeconds = 0.0;  // as timed on the scene's own system
    double factorEntries = 0.0;
    std::vector<StageCost> stages;
    std::vector<std::string> assumes;  // on what this rests, a sentence each
};

struct ModelSummary {
    ModelCounts counts;
    std::vector<LeftOut> leftOut;
    CostEstimate estimate;
};

/// Counts, lists and estimates; solves the scene's own system a few times to see how long that takes, so the estimate
/// differs from call to call.
/// \param scene as it is solved: what `cutScene` makes of it. \param cut of it, for what the cut left out; null: none.
/// \param stop where it becomes true, counting ends soon and there is no summary; null: it runs to its end.
/// \pre the scene was checked without errors and has blocks.
std::optional<ModelSummary> makeModelSummary(const Scene& scene, const SceneCut* cut,
                                             const std::atomic<bool>* stop = nullptr);

/// The parts of it.
ModelCounts countParts(const Model& model, const State& start);
std::vector<LeftOut> leftOutOf(const Scene& scene, const SceneCut* cut, const Model& model,
                               const ModelCounts& counts);
std::optional<CostEstimate> estimateCost(const Scene& scene, const Model& model, const State& start,
                                         const ModelCounts& counts, const std::atomic<bool>* stop = nullptr);

}  // namespace keyblock
