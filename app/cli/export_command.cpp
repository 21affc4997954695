// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The verb `export`: one table of a run as a CSV file, whole or not at all.
#include "app/cli/commands.h"
#include "app/cli/output.h"
#include "solver/files/run_store.h"
#include "solver/files/whole_file.h"
#include "solver/results/tables.h"

namespace keyblock::cli {

namespace {

TableKind tableOf(const ExportOptions& options) {
    const std::optional<TableKind> kind = tableKindOf(options.table);
    if (!kind) {
        std::string names;
        for (const std::string_view word : tableWords())
            names += (names.empty() ? "" : ", ") + std::string(word);
        throw UsageError("there is no table '" + options.table + "'; there are " + names);
    }
    if (options.bolt && !hasBolts(*kind))
        throw UsageError("table " + options.table + " is not by bolt; leave --bolt out");
    return *kind;
}

}  // namespace

ExitCode perform(const ExportOptions& options) {
    const TableKind kind = tableOf(options);
    const RunStore store(options.run);
    const TableFilterReading reading = readTableFilter(store.scene(), options.stage, options.bolt, options.at);
    if (!reading.filter)
        throw UsageError(reading.problem);
    writeWholeFile(options.out, [&](std::ostream& out) { writeTable(kind, store, *reading.filter, out); });
    return Done;
}

}  // namespace keyblock::cli
