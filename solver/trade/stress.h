// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Pushes a scene along its numerical and physical settings until something breaks, and
// reports what breaks first, how far the answer moved, and what to set.
#pragma once

#include "solver/trade/trade_point.h"

#include <functional>
#include <string>
#include <vector>

namespace keyblock {

/// One change of a scene. A numerical setting or a move of all coordinates should not change the answer; a physical one,
/// such as a load, may.
struct StressPush {
    std::string axis;  // time step, penalty ratio, tolerance, stiffness, load, coordinates
    std::string text;  // e.g. "× 10"
    double decades = 0.0;  // size of the push, as a power of ten
    bool physical = false;
    std::string remedy;  // what to set if the scene breaks here
    std::function<void(Scene&)> apply;
};

enum class StressEnding { Same, Moved, Refused, Stopped, Verdict };

/// `same`, `moved`, `refused`, `stopped` or `verdict`.
std::string_view wordOf(StressEnding ending);

struct StressPoint {
    StressPush push;
    StressEnding ending = StressEnding::Same;
    double moved = 0.0;  // largest relative change of a quantity
    std::string quantity;  // the one that changed most
    std::string reason;  // of a refusal or a stop
    std::vector<std::string> warnings;  // that the scene as given does not get
    double seconds = 0.0;
};

struct StressTest {
    std::vector<std::string> quantities;
    TradePoint own;  // the scene as given
    std::vector<StressPoint> points;  // in order of the size of the push within each axis
    bool interrupted = false;
};

struct StressSettings {
    /// Runs a scene. \param label what is run, with its number.
    std::function<void(const Scene& scene, const SceneCut& cut, const std::string& label, Sink& sink)> run;
    std::function<void(const StressPoint&)> measured;  // after each run; may be empty
};

/// Relative change of a quantity from which the answer counts as moved.
inline constexpr double stressMoved = 0.02;

/// The pushes that apply to a scene.
std::vector<StressPush> stressPushes(const Scene& scene);

/// The scene moved by an offset [m]: every position in it.
Scene movedBy(Scene scene, const Point& offset);

/// Runs the scene as given and with every push, one after another.
/// \param stress receives the points as they are measured. \return false if it was stopped.
/// \pre `checkScene(scene)` found no error, and the scene has stages.
bool measureStress(const Scene& scene, const StressSettings& settings, StressTest& stress);

/// Index of the smallest numerical push that breaks the scene or moves its answer, or, if there is none, of the
/// smallest physical one that breaks it; −1: nothing breaks.
int firstToBreak(const StressTest& stress);

/// What breaks first, how far the answer moved, and what to set; a few sentences.
std::string stressAnswer(const StressTest& stress);

}  // namespace keyblock
