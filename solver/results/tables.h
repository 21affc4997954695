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

enum class TableKind { History, Events, Bolts, Blocks, Contacts, Energy, Forces };

/// The tables' names, in the order of `TableKind`.
std::span<const std::string_view> tableWords();

/// The table of that name; nothing when there is none.
std::optional<TableKind> tableKindOf(std::string_view word);

/// Whether `filter.bolt` means anything to the table.
bool hasBolts(TableKind kind);

/// The one frame at the moment that the filter gives, or the last of its stage or of the run. Several frames may
/// share a moment: of those the last one counts. Nothing when no frame was kept.
std::optional<std::size_t> frameAt(const RunSource& run, const TableFilter& filter);

/// Writes header and rows. The tables of a frame (bolts, blocks, contacts, forces) show the last one unless the filter says
/// otherwise, the others every row.
void writeTable(TableKind kind, const RunSource& run, const TableFilter& filter, std::ostream& out);

}  // namespace keyblock
