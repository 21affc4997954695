// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Quantities requested by a scene, read from the results of its run.
#pragma once

#include "solver/results/run_source.h"
#include "solver/scene/quantity_text.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace keyblock {

/// The parts of a run from which quantities are read.
struct RecordedRun {
    const Scene& scene;  // as run
    std::span<const HistoryRow> history;  // in order of time, with the columns of `historyColumns(scene)`
    std::span<const Event> events;  // in order of time
    std::span<const StageRecord> stages;  // those begun so far, in order
};

/// A number, the order of events, or the reason why there is neither.
struct Measurement {
    std::optional<double> value;  // SI; of `stands` 1 or 0; none for `order`
    std::string problem;
    std::vector<std::string> order;  // of `order`: bolts, joints or blocks in order of the first event of each
};

/// Reads a quantity. There is a problem instead of a value if the history has no rows, if the column of the quantity
/// contains no number, if the event did not occur, if the scene is not known to be stable or unstable, or if the
/// quantity needs more than one run.
Measurement measure(const Quantity& quantity, const RecordedRun& run);

/// Reads a quantity that is given as a string, written as in the scene's `quantities`. There is a problem instead of a
/// value if the string does not match the scene.
Measurement measure(std::string_view text, const RecordedRun& run);

/// The order in words, with the number of events that are left out beyond the first `most`.
std::string orderText(const std::vector<std::string>& order, std::size_t most);

/// Reads a quantity from a run kept in memory. The quantity is a string, written as in the scene's `quantities`.
Measurement measure(std::string_view text, const Scene& scene, const Results& results);

/// Comparison of a value computed by the run with the value that the scene expects.
struct MeasuredComparison {
    Expected expected;
    Measurement measured;
    double deviation = 0.0;  // relative to the expected value; absolute if that is 0
    bool within = false;  // deviation is within the tolerance; false if nothing was measured
};

/// Compares one entry of `about.expected` with the results of the run.
MeasuredComparison compare(const Expected& expected, const RecordedRun& run);

}  // namespace keyblock
