// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbers that a scene requests, read from the results of its run.
#pragma once

#include "solver/results/results.h"
#include "solver/scene/quantity_text.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace keyblock {

/// A number, or why there is none.
struct Measurement {
    std::optional<double> value;  // SI
    std::string problem;
};

/// Reads a quantity from the history [rows in order of time, columns of `historyColumns(scene)`] and the events.
/// No row, no number in the column, or no such event: a problem.
Measurement measure(const Quantity& quantity, const Scene& scene, std::span<const HistoryRow> history,
                    std::span<const Event> events);

/// The same for a text as in `quantities`; a text that does not fit the scene is a problem.
Measurement measure(std::string_view text, const Scene& scene, std::span<const HistoryRow> history,
                    std::span<const Event> events);

/// The same for a run kept in memory.
Measurement measure(std::string_view text, const Scene& scene, const Results& results);

/// A measured number and the one that the scene expects.
struct MeasuredComparison {
    Expected expected;
    Measurement measured;
    double deviation = 0.0;  // relative to the expected value; absolute where that is 0
    bool within = false;  // of the tolerance; false where nothing was measured
};

/// Compares one of `about.expected` with what the run gave.
MeasuredComparison compare(const Expected& expected, const Scene& scene, std::span<const HistoryRow> history,
                   std::span<const Event> events);

}  // namespace keyblock
