// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The contents of the report of a run. The header does not need Qt.
#pragma once

#include "solver/results/quantity_estimate.h"
#include "solver/results/run_source.h"
#include "ui/report/report_document.h"
#include "ui/report/report_template.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace keyblock {

/// A file or scene from which a report was made.
struct ReportInput {
    std::string what, name, hash;  // SHA-256 in hexadecimal digits
};

/// What the user and the program add to the results.
struct ReportRequest {
    ReportTemplate layout = defaultTemplate();
    std::optional<ReportLogo> logo;
    std::optional<Scene> given;  // the scene before it was cut; null: domain and joint sets are not described
    std::optional<ErrorEstimate> estimate;  // errors estimated by runs with finer settings; null: not estimated
    std::string project, author, date;  // as given by the user; empty: left out
    std::string runName;  // name of the run store
    std::string program;  // name, version and build of this program
    std::string runProgram;  // name and version of the program that wrote the run
    std::string verification;  // `verificationStatement`
    std::vector<ReportInput> inputs;
    std::vector<std::string> commands;  // that make the run and the report again
    /// Called before each section with its heading and the share done; may throw to stop.
    std::function<void(const std::string& heading, double done)> progress{};
    /// Paints a chart by calling its argument, for example in the thread of the window, and passes on its exceptions;
    /// empty: it is painted at once.
    std::function<void(const std::function<void()>& paint)> draw{};
};

/// The report of a run, finished or not. The same run and request give the same document.
/// \throws CannotDraw if a figure does not fit in memory
ReportDocument reportOf(const RunSource& run, const ReportRequest& request);

}  // namespace keyblock
