// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The contents of the report of a study: statistics of its cases instead of sections.
#pragma once

#include "solver/study/sweep_folder.h"
#include "solver/study/sweep_results.h"
#include "ui/report/report.h"

#include <string>
#include <vector>

namespace keyblock {

/// A figure that was collected with the study.
struct StudyFigure {
    std::string name;  // of its file, without extension
    std::string svg;
};

/// The report of a sweep, finished or not. The same results and request give the same document.
/// \param figures shown in this order.
ReportDocument studyReportOf(const Sweep& sweep, const SweepResults& results, const std::vector<StudyFigure>& figures,
                             const ReportRequest& request);

}  // namespace keyblock
