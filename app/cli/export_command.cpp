// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The command `export`: writes one table of a run as a CSV file, a figure, an
// animation, or a folder for ParaView. The output is written completely or not at all.
#include "app/cli/cli_commands.h"
#include "app/cli/export_animation.h"
#include "app/cli/export_figure.h"
#include "app/cli/output.h"
#include "app/cli/output_files.h"
#include "app/cli/store_warning.h"
#include "solver/files/run_store/run_store.h"
#include "solver/files/vtk/vtk_export.h"
#include "solver/files/atomic_file.h"
#include "solver/results/tables.h"

namespace keyblock::cli {

namespace {

TableKind tableOf(const ExportOptions& options) {
    const std::optional<TableKind> kind = tableKindOf(*options.table);
    if (!kind) {
        std::string names;
        for (const std::string_view word : tableWords())
            names += (names.empty() ? "" : ", ") + std::string(word);
        throw UsageError("there is no table '" + *options.table + "'; there are " + names);
    }
    if (options.bolt && !hasBolts(*kind))
        throw UsageError("table " + *options.table + " has no rows of bolts; omit --bolt");
    return *kind;
}

/// Refuses the options of figures, which have no meaning for a table.
void refuseFigureOptions(const ExportOptions& options) {
    const auto refuse = [](bool given, const std::string& option) {
        if (given)
            throw UsageError(option + " applies to figures and animations only; omit it");
    };
    refuse(options.quantity.has_value(), "--quantity");
    refuse(options.width.has_value(), "--width");
    refuse(options.dpi.has_value(), "--dpi");
    refuse(options.deformed.has_value(), "--deformed");
    refuse(options.whole, "--whole");
}

TableFilter filterOf(const ExportOptions& options, const Scene& scene) {
    const TableFilterReading reading = readTableFilter(scene, options.stage, options.bolt, options.at);
    if (!reading.filter)
        throw UsageError(reading.problem);
    return *reading.filter;
}

ExitCode exportVtk(const ExportOptions& options) {
    if (options.table || !options.out.empty() || options.bolt)
        throw UsageError("--vtk writes the whole run into its folder; omit --table, --out and --bolt");
    refuseFigureOptions(options);
    const RunStore store(options.run);
    warnOfMissingResults(store, options.run);
    writeVtkFolder(store, filterOf(options, store.scene()), *options.vtk);
    return Done;
}

ExitCode exportFigure(const ExportOptions& options) {
    checkFigureOptions(options);
    const RunStore store(options.run);
    warnOfMissingResults(store, options.run);
    return exportFigure(options, store, filterOf(options, store.scene()));
}

ExitCode exportAnimation(const ExportOptions& options) {
    checkAnimationOptions(options);
    const OutputFile file{*options.animation};
    if (!mayBeWritten({&file, 1}, {&options.run, 1})) return Usage;
    const RunStore store(options.run);
    warnOfMissingResults(store, options.run);
    return exportAnimation(options, store, filterOf(options, store.scene()));
}

}  // namespace

ExitCode perform(const ExportOptions& options) {
    if (options.perSecond && !options.animation)
        throw UsageError("--fps applies to --animation only; omit it");
    if (!options.references.empty() && options.figure != "curves")
        throw UsageError("--reference applies to --figure curves only; omit it");
    if (options.vtk)
        return exportVtk(options);
    if (options.animation)
        return exportAnimation(options);
    if (!(options.table || options.figure) || options.out.empty())
        throw UsageError("choose what to export: --table NAME or --figure NAME with --out FILE, --animation FILE, or "
                         "--vtk DIR");
    if (options.figure)
        return exportFigure(options);
    refuseFigureOptions(options);
    const TableKind kind = tableOf(options);
    const OutputFile file{options.out};
    if (!mayBeWritten({&file, 1}, {&options.run, 1})) return Usage;
    const RunStore store(options.run);
    warnOfMissingResults(store, options.run);
    const TableFilter filter = filterOf(options, store.scene());
    writeAtomically(options.out, [&](std::ostream& out) { writeTable(kind, store, filter, out); });
    return Done;
}

}  // namespace keyblock::cli
