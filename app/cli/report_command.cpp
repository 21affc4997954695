// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The command `report`: writes the report of a run or of a study as PDF or HTML.
#include "app/cli/cli_commands.h"
#include "app/cli/output.h"
#include "app/cli/output_files.h"

#ifdef KEYBLOCK_HAS_FIGURES
#include "solver/files/atomic_file.h"
#include "solver/files/read_error.h"
#include "ui/figure/figure.h"
#include "ui/report/stored/stored_report.h"
#endif

namespace keyblock::cli {

ExitCode perform([[maybe_unused]] const ReportOptions& options) {
#ifndef KEYBLOCK_HAS_FIGURES
    throw UsageError(
        "this program was built without figures; build it with Qt 5 and QCustomPlot, or use info and export");
#else
    const std::string ending = options.out.extension().string();
    if (ending != ".pdf" && ending != ".html")
        throw UsageError("'" + options.out.string() + "': a report is written as .pdf or .html");
    std::vector<std::filesystem::path> sources{options.run};
    if (options.layout) sources.push_back(*options.layout);
    const OutputFile file{options.out, options.overwrite};
    if (!mayBeWritten({&file, 1}, sources)) return Usage;
    const ReportOrder order{options.run, options.out, options.layout, options.project, options.author, options.date,
                            {},          {}};
    try {
        const ReportFile report = reportFile(order);
        if (!report.warning.empty()) printToError("warning: " + report.warning + "\n");
        writeAtomically(options.out, [&](std::ostream& out) { out << report.bytes; });
    } catch (const CannotDraw& problem) {
        throw CannotRead("cannot draw the report: " + std::string(problem.what()));
    }
    return Done;
#endif
}

}  // namespace keyblock::cli
