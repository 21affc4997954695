// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Estimates how far the quantities of interest of a run are from those of infinitely
// fine time steps, increments and bolt divisions, by two more runs.
#pragma once

#include "solver/results/quantity_estimate.h"
#include "solver/results/results.h"
#include "solver/run/sink.h"
#include "solver/scene/scene_cut.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace keyblock {

/// A scene with one setting made twice as fine.
struct Refinement {
    std::string text;  // e.g. "half the time step"
    Scene scene;
    double factor = 1.0;  // error of the quantities over their change by the refinement
};

/// The refinements of a scene: half the time step and twice the increments, where there are time steps or given
/// increments, and twice the divisions of the most loaded bolt, of its pattern, or of all bolts with automatic
/// divisions if it is one of these. A change by a factor of two of a setting of first order (time steps) leaves as much
/// error as it removes, one of second order (divisions) a third (Richardson 1911). The divisions of a bond that is
/// given per node stay, because its strength depends on them.
/// \param results of the scene's run, with its last frame.
std::vector<Refinement> refinementsOf(const Scene& scene, const Results& results);

/// Runs a scene, whose cut is given, and passes the results to a sink. \param label what is run.
using EstimateRun = std::function<void(const Scene& scene, const SceneCut& cut, const std::string& label, Sink& sink)>;

/// Estimates the errors of the quantities of a scene, or of those proposed if it names none. The error is the sum of
/// those of the refinements.
/// \return nothing if a run was stopped.
std::optional<ErrorEstimate> estimateErrors(const Scene& scene, const Results& results, const EstimateRun& run);

}  // namespace keyblock
