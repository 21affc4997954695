// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which rows of a table are wanted: a stage, a bolt, and a moment of time.
#pragma once

#include "solver/scene/scene.h"

#include <optional>
#include <string>
#include <vector>

namespace keyblock {

enum class When { All, Last, At };

struct TableFilter {
    std::optional<int> stage;  // index; null: every stage
    std::optional<int> bolt;  // index; null: every bolt
    std::optional<When> when;  // null: the table's own default
    double time = 0.0;  // of `At`, within `stage`
    std::optional<long> events{};  // of frames at the same time, the one after so many events; null: all of them
};

/// What became of the words of a filter: the filter, or what is wrong with them.
struct TableFilterReading {
    std::optional<TableFilter> filter;
    std::string problem;
};

/// Reads the names of a stage and a bolt and a moment `STAGE:TIME`, `last` or `all`; null where one is not given.
TableFilterReading readTableFilter(const Scene& scene, const std::optional<std::string>& stage,
                                   const std::optional<std::string>& bolt, const std::optional<std::string>& at);

/// When a row of a table is.
struct RowMoment {
    int stage = 0;
    double time = 0.0;
};

/// Which of `moments` [in order of time] the filter's stage and moment select, as indices. `At` takes those at the
/// time nearest to the requested one.
std::vector<std::size_t> selected(const std::vector<RowMoment>& moments, const TableFilter& filter, When byDefault);

}  // namespace keyblock
