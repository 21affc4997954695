// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Selection of the rows of a table by stage, bolt and time.
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
    std::optional<When> when;  // null: the default of the table
    double time = 0.0;  // within `stage`; used if `when` is `At`
    std::optional<long> events{};  // selects, among frames at one time, the one after this many events; null: the last
};

/// A filter read from strings, or an error message if the strings are not valid.
struct TableFilterReading {
    std::optional<TableFilter> filter;
    std::string problem;
};

/// Reads a filter from strings, each of which may be null.
/// \param stage the name of the stage.
/// \param bolt the name of the bolt.
/// \param at `STAGE:TIME`, `last` or `all`.
TableFilterReading readTableFilter(const Scene& scene, const std::optional<std::string>& stage,
                                   const std::optional<std::string>& bolt, const std::optional<std::string>& at);

/// Stage and time of a row of a table.
struct RowMoment {
    int stage = 0;
    double time = 0.0;
};

/// Indices of the rows selected by the filter's stage and time. `When::At` selects the rows at the time nearest to the
/// requested one.
/// \param moments the stage and time of each row, in order of time.
/// \param byDefault the selection used if `filter.when` is null.
std::vector<std::size_t> selected(const std::vector<RowMoment>& moments, const TableFilter& filter, When byDefault);

}  // namespace keyblock
