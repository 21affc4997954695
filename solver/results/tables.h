// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The CSV tables of a run. Column names carry SI units; the first two columns of
// every table are the stage's name and the time within it.
#pragma once

#include "solver/results/run_source.h"
#include "solver/results/table_filter.h"

#include <optional>
#include <ostream>
#include <span>
#include <string_view>

namespace keyblock {

enum class TableKind { History, Events, Bolts, Blocks, Contacts, Energy, Forces, Design };

/// Names of the tables, in the order of `TableKind`.
std::span<const std::string_view> tableWords();

/// The table with this name; none if there is no such table.
std::optional<TableKind> tableKindOf(std::string_view word);

/// Whether the table can be filtered by bolt.
bool hasBolts(TableKind kind);

/// Index of the frame selected by the filter. If the filter gives no time, this is the last frame of the stage or, if
/// it gives no stage either, of the run. Among several frames at the selected time, the one with `filter.events` events
/// is taken or, if there is none, the last. None if no frame matches the filter.
std::optional<std::size_t> frameAt(const RunSource& run, const TableFilter& filter);

/// Writes a table: a header, then the rows. By default, tables made from frames (bolts, blocks, contacts, forces, design) show
/// the last frame; the other tables show every row.
void writeTable(TableKind kind, const RunSource& run, const TableFilter& filter, std::ostream& out);

}  // namespace keyblock
