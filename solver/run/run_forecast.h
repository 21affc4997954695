// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How long a run will take, from its beginning and, where bolts dominate, from the
// whole run with coarser bolts.
#pragma once

#include "solver/engine/model/model.h"
#include "solver/run/pilot_run.h"
#include "solver/scene/scene.h"

#include <atomic>
#include <optional>
#include <vector>

namespace keyblock {

/// A stage as far as it is known without running it.
struct PlannedStage {
    bool dynamic = false;
    bool loaded = true;  // a load changes; false: one search for equilibrium
    double duration = 1.0;  // [s], or 1
    double steps = 0.0;  // increments, or time steps
    double passes = 0.0;  // iterations, from counts in other scenes
};

struct ForecastStage {
    double seconds = 0.0;
    double passes = 0.0;
    double known = 0.0;  // iterations that were made
    bool over = false;  // the stage was run to its end
};

struct RunForecast {
    std::vector<ForecastStage> stages;
    double seconds = 0.0;  // CPU time of all stages on one thread [s]
    double known = 0.0;  // CPU time of that which was run [s]
    bool whole = false;  // the run was made to its end
    bool searching = false;  // a search for equilibrium had not ended
    bool fromCoarse = false;  // from runs with coarser bolts
};

/// Makes the forecast in about a second of CPU time at most.
/// \param scene as solved, with its collapse stages; \param planned one for each stage.
/// \return nothing if `stop` became true.
std::optional<RunForecast> forecastRun(const Scene& scene, const Model& model, const std::vector<PlannedStage>& planned,
                                       const std::atomic<bool>* stop);

/// The forecast from the beginning of a run alone.
RunForecast forecastFrom(const PilotRun& pilot, const std::vector<PlannedStage>& planned);

}  // namespace keyblock
