// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the sections of a report have in common: the results that several of them read,
// and how values are written. Each function adds the contents of one section.
#pragma once

#include "solver/results/bolt_design.h"
#include "solver/results/run_source.h"
#include "solver/results/verdict.h"
#include "ui/report/report.h"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace keyblock::report {

struct Facts {
    const RunSource& run;
    const ReportRequest& request;
    std::vector<StageRecord> stages;
    std::vector<Event> events;
    Verdict verdict;
    std::vector<int> settled;  // `settledBlocks`
    std::vector<BoltDesign> designs;  // in the last frame

    Facts(const RunSource& source, const ReportRequest& wanted);
    const Scene& scene() const { return run.scene(); }
    std::string block(int index) const;
};

/// The number with four significant digits, as in 0.0125 or 9.988·10⁻⁵.
std::string numeral(double value);

/// The number in `unit` with four significant digits, without the unit. \pre `unit` is a symbol of the table of units
std::string inUnit(double value, std::string_view unit);

/// The number in per cent, to a tenth: 16.8.
std::string percentText(double share);

void addText(ReportSection& section, const std::string& text, ReportTextKind kind = ReportTextKind::Body);

/// Adds the table unless it has no rows.
void addTable(ReportSection& section, ReportTable table);

/// The document with its title block and the sections of the template. \param own title without a template
/// \param what names `own` in the title block \param add adds the contents of a section
ReportDocument assembled(const std::string& own, const std::string& what, const ReportRequest& request,
                         const std::function<void(ReportContent, ReportSection&)>& add);

/// Adds the contents that do not depend on results: verification, inputs, commands.
void addCommonContent(const ReportRequest& request, ReportContent content, ReportSection& section);

void addSummary(const Facts& facts, ReportSection& section);
void addSectionFigures(const Facts& facts, ReportSection& section);
void addModel(const Facts& facts, ReportSection& section);
void addStages(const Facts& facts, ReportSection& section);
void addNumerics(const Facts& facts, ReportSection& section);
void addBolts(const Facts& facts, ReportSection& section);
void addEvents(const Facts& facts, ReportSection& section);
void addCurves(const Facts& facts, ReportSection& section);
void addDiagnostics(const Facts& facts, ReportSection& section);

}  // namespace keyblock::report
