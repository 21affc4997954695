// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The numerical settings that can be traded against time in a scene, one axis for each.
// Only settings that the scene uses are varied: no divisions without bolts, no time
// step without a dynamic stage.
#pragma once

#include "solver/scene/scene.h"

#include <functional>
#include <string>
#include <vector>

namespace keyblock {

/// Axes that change the time of a run without changing its counted work.
inline constexpr const char *sleepAxisName = "sleep_tolerance", *threadsAxisName = "threads";

/// Axis of the presets.
inline constexpr const char* presetAxisName = "preset";

/// Axis that changes the rock bolts instead of the way in which they are computed: it is measured, never recommended.
inline constexpr const char* bondAxisName = "bond";

/// One value on an axis.
struct TradeSetting {
    std::string axis;
    std::string text;  // the value, e.g. "60" or "0.001 s"
    std::vector<std::string> overrides;  // path=value, as for `--set`
    std::function<void(Scene&)> apply;
    double size = 0.0;  // of the discretization or tolerance, smaller for finer settings; 0: a choice, not a size
    double cost = 1.0;  // estimated run time over that of the scene's own setting
    int threads = 1;
};

/// A setting with the values to try, from coarse to fine where they have sizes.
struct TradeAxis {
    std::string name;
    std::vector<TradeSetting> settings;  // without the scene's own value
    double ownSize = 0.0;  // size of the scene's own value; 0: unknown, or not a size
    bool refines = false;  // results converge as the size decreases
};

/// Model size on which the cost of divisions depends.
struct TradeModel {
    int blockUnknowns = 0;
    int bolts = 0, boltUnknowns = 0;
    int threads = 1;  // most that the machine has
};

/// The axes of a scene, in the order in which they are measured.
/// \pre `checkScene(scene)` found no error.
std::vector<TradeAxis> tradeAxes(const Scene& scene, const TradeModel& model);

/// Several settings together, one from each axis.
TradeSetting combined(const std::string& axis, const std::vector<TradeSetting>& settings);

}  // namespace keyblock
