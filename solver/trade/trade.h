// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Measures what the numerical settings of a scene cost and what they change: one
// setting at a time from the scene's own, then combinations of those that change
// little.
#pragma once

#include "solver/trade/trade_point.h"

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace keyblock {

/// A setting that was not run, with the reason.
struct TradeLeftOut {
    std::string axis, setting, reason;
};

struct Trade {
    std::vector<std::string> quantities;
    bool proposed = false;  // the scene names no quantities
    std::vector<TradePoint> points;  // the scene's own settings first
    std::vector<TradeSetting> settings;  // of each point
    std::size_t planned = 0;  // number of runs in all, while they are made; fewer if some are left out
    int reference = 0;  // point with the finest settings, with which all others are compared
    std::map<std::string, double> ownSizes;  // per axis: size of the scene's own setting, where it is known
    std::vector<TradeLeftOut> leftOut;
    bool interrupted = false;
};

struct TradeSettings {
    std::optional<double> budget;  // [s] for all runs together; null: no limit
    /// Runs a scene. \param label what is run, with the number of the run and the time left for all of them.
    std::function<void(const Scene& scene, const SceneCut& cut, int threads, const std::string& label, Sink& sink)> run;
    /// The point with this axis and setting if it was measured before; may be empty.
    std::function<std::optional<TradePoint>(const TradeSetting&)> known;
    std::function<void(const TradePoint&)> measured;  // after each run; may be empty
};

/// Axis names of the points that are not on an axis.
inline constexpr const char* ownPoint = "own settings";
inline constexpr const char* referencePoint = "reference";
inline constexpr const char* combinationPoint = "combination";

/// Runs the scene with its own settings, with the finest ones, with one setting changed at a time, and with
/// combinations.
/// \param trade its quantities are read if there are any, otherwise those of the scene, or those proposed; it receives
///        the points as they are measured, so that they remain if the trade is stopped.
/// \return false if it was stopped.
/// \pre `checkScene(scene)` found no error, and the scene has stages.
bool measureTrade(const Scene& scene, const TradeSettings& settings, Trade& trade);

}  // namespace keyblock
