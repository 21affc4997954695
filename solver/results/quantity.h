// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Quantities requested by a scene, read from the results of its run.
#pragma once

#include "solver/results/results.h"
#include "solver/scene/quantity_text.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace keyblock {

/// A number, or the reason why there is none.
struct Measurement {
    std::optional<double> value;  // SI
    std::string problem;
};

/// Reads a quantity from the history and the events. There is a problem instead of a value if the history has no rows,
/// if the column of the quantity contains no number, or if the event did not occur.
/// \param history the rows in order of time, with the columns of `historyColumns(scene)`.
Measurement measure(const Quantity& quantity, const Scene& scene, std::span<const HistoryRow> history,
                    std::span<const Event> events);

/// Reads a quantity that is given as a string, written as in the scene's `quantities`. There is a problem instead of a
/// value if the string does not match the scene.
Measurement measure(std::string_view text, const Scene& scene, std::span<const HistoryRow> history,
                    std::span<const Event> events);

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
MeasuredComparison compare(const Expected& expected, const Scene& scene, std::span<const HistoryRow> history,
                   std::span<const Event> events);

}  // namespace keyblock
