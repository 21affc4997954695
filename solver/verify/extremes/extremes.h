// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Extremes: scenes whose answer is known are pushed to the limits of the method, along
// one axis at a time and in random combinations. Every run must end with the right
// answer, a refusal, a warning or a clear stop; none may be wrong in silence.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace keyblock {

/// How a run at an extreme ends. `Warned`: the answer is not right, but a warning of the check or of the run, which the
/// same scene under ordinary conditions does not get, says so. `Refused`: the check finds an error, so nothing is run.
/// `Stopped`: the run ends with a message and keeps its results. `Wrong`: none of these.
enum class ExtremeEnding { Right, Warned, Refused, Stopped, Wrong };

inline constexpr int extremeEndings = 5;

/// `right`, `warned`, `refused`, `stopped` or `wrong`.
std::string_view wordOf(ExtremeEnding ending);

/// One run with the quantity that deviates most from its expected value, in units of its tolerance.
struct ExtremeRun {
    std::string value;  // position on the axis, with its unit; the drawn conditions of a random combination
    bool usual = false;  // an ordinary value, from which the axis is pushed
    ExtremeEnding ending = ExtremeEnding::Wrong;
    std::string reason;  // message of the refusal, stop, warning or miss; empty if the answer is right
    std::string quantity;  // with its unit; empty if nothing was measured
    double measured = 0.0, expected = 0.0, tolerance = 0.0;
    double seconds = 0.0;  // wall-clock time [s]
};

/// A scene pushed along one axis.
struct ExtremeCase {
    std::string name;
    std::string scene;  // name of the scene
    std::string axis;  // title of the axis
    std::string property;  // what the answer is checked against
    std::string reason;  // why the edge of this axis lies where it does
    std::vector<double> values;
    bool isChoice = false;  // the values are choices without an order
    std::function<ExtremeRun(std::size_t)> run;  // runs the value with this index
};

/// All cases, in the order in which they are printed.
const std::vector<ExtremeCase>& extremeCases();

/// One random combination: a scene and values for all axes that apply to it. The same seed and number give the same
/// combination on every machine.
ExtremeRun randomExtreme(std::uint64_t seed, int number);

/// A case with its runs, one per value.
struct ExtremeCaseRuns {
    ExtremeCase one;
    std::vector<ExtremeRun> runs;
};

struct RandomExtremes {
    std::uint64_t seed = 1;
    std::vector<ExtremeRun> runs;
};

/// Number of runs with each ending, and their times.
struct ExtremeCounts {
    std::array<int, extremeEndings> endings{};
    double median = 0.0, longest = 0.0;  // [s]

    int of(ExtremeEnding ending) const { return endings[static_cast<std::size_t>(ending)]; }
    int all() const;
};

ExtremeCounts countsOf(const std::vector<ExtremeRun>& runs);

}  // namespace keyblock
