// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reports of runs and sweeps on disk: reads the results, the template and its logo, and
// makes the contents of the report's file. The header does not need Qt.
#pragma once

#include "ui/report/report.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

namespace keyblock {

struct ReportOrder {
    std::filesystem::path source;  // run store, or folder of a sweep
    std::filesystem::path out;  // the file that will be written; its extension is .pdf or .html
    std::optional<std::filesystem::path> layout;  // template; null: all sections
    std::string project, author, date;
    std::function<void(const std::string& heading, double done)> progress{};  // as in `ReportRequest`
    std::function<void(const std::function<void()>&)> draw{};  // as in `ReportRequest`
};

struct ReportFile {
    std::string bytes;
    std::string warning;  // that results may be missing; empty: none
};

/// Makes the file of a report; does not write it. The same results, order and build give the same bytes.
/// \throws CannotRead if the results, the template or the logo cannot be read or used, CannotDraw if a figure cannot be
/// painted
ReportFile reportFile(const ReportOrder& order);

}  // namespace keyblock
