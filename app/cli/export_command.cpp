// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The verb `export`: one table of a run as a CSV file, or a folder for ParaView,
// whole or not at all.
#include "app/cli/commands.h"
#include "app/cli/output.h"
#include "solver/files/run_store.h"
#include "solver/files/vtk_export.h"
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

TableFilter filterOf(const RunStore& store, const ExportOptions& options) {
    const TableFilterReading reading = readTableFilter(store.scene(), options.stage, options.bolt, options.at);
    if (!reading.filter)
        throw UsageError(reading.problem);
    return *reading.filter;
}

ExitCode exportVtk(const ExportOptions& options) {
    if (!options.table.empty() || !options.out.empty() || options.bolt)
        throw UsageError("--vtk writes all of a run into its folder; leave --table, --out and --bolt out");
    const RunStore store(options.run);
    writeVtkFolder(store, filterOf(store, options), *options.vtk);
    return Done;
}

}  // namespace

ExitCode perform(const ExportOptions& options) {
    if (options.vtk)
        return exportVtk(options);
    if (options.table.empty() || options.out.empty())
        throw UsageError("say what to export: --table NAME --out FILE.csv, or --vtk DIR");
    const TableKind kind = tableOf(options);
    const RunStore store(options.run);
    const TableFilter filter = filterOf(store, options);
    writeWholeFile(options.out, [&](std::ostream& out) { writeTable(kind, store, filter, out); });
    return Done;
}

}  // namespace keyblock::cli
