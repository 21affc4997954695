// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Model summary of a scene, made before anything is run: counts of what will be
// modelled, features that are left out because the scene does not need them, and an
// estimate of run time and memory.
#pragma once

#include "solver/engine/model/model.h"
#include "solver/engine/model/state.h"
#include "solver/run/next_left_out.h"
#include "solver/scene/scene_cut.h"

#include <atomic>
#include <optional>
#include <string>
#include <vector>

namespace keyblock {

struct ModelCounts {
    int blocks = 0;  // rock bodies: blocks that are not divided, and cells
    int cells = 0;  // cells among the rock bodies
    int plates = 0;  // face plates modelled as blocks
    int fixed = 0;  // bodies that are fixed as a whole
    int heldPoints = 0;  // point supports
    int bolts = 0, nodes = 0;
    int realAnchors = 0;  // nodes with an anchor of the bolt type
    int contacts = 0;  // corner-to-edge contacts at the start, each with a normal and a shear spring
    int gluedEdges = 0;
    int blockUnknowns = 0;  // six for each block that is not fixed as a whole
    int plateUnknowns = 0;
    int boltUnknowns = 0;  // three per node; two if the bolt type has no bending stiffness

    int unknowns() const { return blockUnknowns + plateUnknowns + boltUnknowns; }
};

/// A feature of the program that the model leaves out because the scene does not need it.
struct LeftOut {
    std::string what;
    std::string why;  // reason why the scene does not need it
    std::string saves;
};

struct StageCost {
    std::string name;
    double steps = 0.0;  // increments, or time steps
    double passes = 0.0;  // iterations: linear systems to be solved
    double least = 0.0, most = 0.0;  // estimated range of the number of iterations
};

/// Estimated run time and memory.
struct CostEstimate {
    double seconds = 0.0;  // CPU time on one thread
    double secondsLeast = 0.0, secondsMost = 0.0;  // half and double
    double memory = 0.0;  // peak memory [bytes]
    double passSeconds = 0.0, stepSeconds = 0.0;  // time per iteration and step [s], measured on the scene's own system
    double factorEntries = 0.0;  // stored entries of the matrix factor
    std::vector<StageCost> stages;
    std::vector<std::string> assumes;  // assumptions of the estimate, one sentence each
};

struct ModelSummary {
    ModelCounts counts;
    std::vector<LeftOut> leftOut;
    std::vector<NextLeftOut> next;  // what the user could leave out, not measured
    CostEstimate estimate;
};

/// Makes the whole summary. The time is measured at the beginning of the run, whose results are discarded, so the estimate
/// takes up to about a second and varies from call to call.
/// \param scene the scene as solved: the result of `cutScene`.
/// \param cut the cut that produced `scene`, used to list what the cut left out; null if the scene was not cut.
/// \param stop if it becomes true, the function soon returns without a summary; null: the function cannot be stopped.
/// \pre `checkScene` found no error in the scene, and the scene has blocks.
std::optional<ModelSummary> makeModelSummary(const Scene& scene, const SceneCut* cut,
                                             const std::atomic<bool>* stop = nullptr);

// The parts of the summary.
ModelCounts countParts(const Model& model, const State& start);
std::vector<LeftOut> leftOutOf(const Scene& scene, const SceneCut* cut, const Model& model,
                               const ModelCounts& counts);
std::optional<CostEstimate> estimateCost(const Scene& scene, const Model& model, const State& start,
                                         const ModelCounts& counts, const std::atomic<bool>* stop = nullptr);

}  // namespace keyblock
