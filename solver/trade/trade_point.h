// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One run of a trade: the quantities of interest that it gives, and what it costs.
#pragma once

#include "solver/results/quantity.h"
#include "solver/results/step_work.h"
#include "solver/run/sink.h"
#include "solver/scene/scene_cut.h"
#include "solver/trade/trade_axes.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace keyblock {

struct TradePoint {
    std::string axis, setting;
    std::vector<std::string> overrides;  // path=value, as for `--set`
    std::string preset;  // with the number of settings that were changed
    std::vector<Measurement> values;  // one per quantity of interest
    double seconds = 0.0;  // CPU time of the run; wall-clock time if it used several threads
    long steps = 0, passes = 0;  // accepted steps, iterations
    StepWork work;
    int unknowns = 0;
    double memory = 0.0;  // peak memory of the run [bytes]; 0: unknown
    int blocksMoved = 0;  // blocks that moved by more than a tenth of their size
    std::string failure;  // reason why the run did not end as planned; empty: it did
    int threads = 1;
    double size = 0.0;  // as in TradeSetting
};

/// Index of the bolt with the largest axial force in the run; −1: there is none.
int mostLoadedBolt(const Results& results);

/// Quantities of interest of a scene that names none, chosen from the results of its run: whether it is stable, the energy
/// balance error, the displacements and openings of monitors, the largest force of the most loaded bolt and its debonded
/// length, and the number and order of the events in bolts.
std::vector<std::string> proposedQuantities(const Scene& scene, const Results& results);

/// Runs a scene, whose cut is given, on a number of threads and passes the results to a sink, as `run` does.
using TradeRun = std::function<void(const Scene& scene, const SceneCut& cut, int threads, Sink& sink)>;

/// Runs a scene with one setting changed.
/// \param quantities the quantities of interest; empty: those of the scene, or those proposed after the run. Receives
///        the quantities that were read.
/// \return nothing if the run was stopped.
std::optional<TradePoint> measurePoint(const Scene& scene, const TradeSetting& setting,
                                       std::vector<std::string>& quantities, const TradeRun& run);

/// Size of the model of a checked scene.
TradeModel tradeModelOf(const Scene& scene);

}  // namespace keyblock
