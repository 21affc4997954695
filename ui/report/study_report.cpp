// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/study_report.h"

#include "ui/report/report_facts.h"
#include "ui/report/report_figures.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace keyblock {

namespace report {

namespace {

constexpr std::size_t mostCases = 40;  // rows of the table of cases without results

struct StudyFacts {
    const Sweep& sweep;
    const SweepResults& results;
    const std::vector<StudyFigure>& figures;
    const ReportRequest& request;
};

std::string countText(long count, const char* one, const char* more) {
    return std::to_string(count) + " " + (count == 1 ? one : more);
}

void addStudySummary(const StudyFacts& facts, ReportSection& section) {
    const SweepResults& results = facts.results;
    const auto all = static_cast<long>(results.cases.size());
    if (!results.criterion.empty()) {
        const FailureShare share = failureShare(results);
        if (share.decided == 0)
            addText(section, "No case is decided by the criterion of failure.", ReportTextKind::Answer);
        else
            addText(section,
                    "The probability of failure is " + percentText(share.probability) +
                        " %, with a 95 % interval from " + percentText(share.interval.low) + " % to " +
                        percentText(share.interval.high) + " %.",
                    ReportTextKind::Answer);
        addText(section, std::to_string(share.fails) + " of " + countText(share.decided, "case fails", "cases fail") +
                             ". A case fails if: " + results.criterion + ".");
        if (share.undecided > 0)
            addText(section, countText(share.undecided, "finished case is", "finished cases are") +
                                 " not decided by the criterion and left out.");
    }
    addText(section,
            std::to_string(results.finished()) + " of " + countText(all, "case has", "cases have") + " finished.");
    if (results.finished() < all)
        addText(section, "The study is not complete; this report shows the results so far.", ReportTextKind::Warning);
}

std::string rangeText(const StudyDistribution& distribution) {
    static constexpr std::array names{"uniform", "triangular", "normal", "lognormal", "seed"};
    std::string text = names.at(static_cast<std::size_t>(distribution.kind));
    const auto add = [&text](const char* name, const std::optional<double>& value) {
        if (value) text += std::string(", ") + name + " " + numeral(*value);
    };
    add("mean", distribution.mean);
    add("deviation", distribution.deviation);
    add("least", distribution.least);
    add("peak", distribution.peak);
    add("most", distribution.most);
    return text;
}

std::string valuesText(const StudyParameter& parameter) {
    if (parameter.distribution) return rangeText(*parameter.distribution);
    if (parameter.range)
        return std::to_string(parameter.range->count) + " values from " + numeral(parameter.range->from) + " to " +
               numeral(parameter.range->to);
    std::string text;
    for (const std::string& value : parameter.values) text += (text.empty() ? "" : ", ") + value;
    return text;
}

void addParameters(const StudyFacts& facts, ReportSection& section) {
    const Study& study = facts.sweep.study;
    static constexpr std::array plans{"all combinations", "Latin hypercube", "Monte Carlo"};
    addText(section, "The cases are chosen by: " + std::string(plans.at(static_cast<std::size_t>(study.plan.kind))) +
                         ", seed " + std::to_string(study.plan.seed) + ".");
    ReportTable parameters{"Values of the scene that vary", {{"Name"}, {"Path in the scene"}, {"Values"}}, {}};
    for (const StudyParameter& one : study.parameters)
        parameters.rows.push_back({one.name.empty() ? one.path : one.name, one.path, valuesText(one)});
    addTable(section, std::move(parameters));
    ReportTable faults{"Faults of installation", {{"Name"}, {"Probability of each bolt, %", true}}, {}};
    for (const StudyFault& one : study.faults) faults.rows.push_back({one.name, percentText(one.probability)});
    addTable(section, std::move(faults));
}

ReportTable statisticsTable(const SweepResults& results) {
    ReportTable table{"Statistics of the cases, in SI units",
                      {{"Value"},
                       {"Cases", true},
                       {"Mean", true},
                       {"Deviation", true},
                       {"Least", true},
                       {"5 %", true},
                       {"Median", true},
                       {"95 %", true},
                       {"Most", true}},
                      {}};
    for (const SweepColumn& column : results.columns) {
        const std::vector<double> sorted = sortedValues(column);
        if (column.role == ColumnRole::Verdict || sorted.empty()) continue;
        const SampleStatistics s = statisticsOf(sorted);
        table.rows.push_back({column.name, std::to_string(s.count), numeral(s.mean), numeral(s.deviation),
                              numeral(s.least), numeral(quantileOf(sorted, 0.05)), numeral(quantileOf(sorted, 0.5)),
                              numeral(quantileOf(sorted, 0.95)), numeral(s.most)});
    }
    return table;
}

bool isInput(const SweepColumn& column) {
    return column.role == ColumnRole::Parameter || column.role == ColumnRole::Fault;
}

/// Rank correlation of each result with each value that varies.
ReportTable correlationTable(const SweepResults& results) {
    ReportTable table{"Rank correlation of results with what varies", {{"Result"}}, {}};
    for (const SweepColumn& input : results.columns)
        if (isInput(input)) table.columns.push_back({input.name, true});
    if (table.columns.size() == 1) return table;
    for (const SweepColumn& result : results.columns) {
        if (isInput(result)) continue;
        table.rows.push_back({result.name});
        for (const SweepColumn& input : results.columns)
            if (isInput(input))
                table.rows.back().push_back(numeral(std::round(100.0 * correlationOf(input, result)) / 100.0));
    }
    return table;
}

ReportTable oddCaseTable(const SweepResults& results) {
    ReportTable table{"Finished cases without results", {{"Case", true}, {"Outcome"}, {"Reason"}}, {}};
    for (const auto& one : results.cases)
        if (one && one->outcome != CaseOutcome::Done && table.rows.size() < mostCases)
            table.rows.push_back({std::to_string(one->number), std::string(wordOf(one->outcome)), one->reason});
    return table;
}

/// "histogram-last-key.uy" as "Histogram last-key.uy".
std::string captionOf(const std::string& name) {
    std::string caption = name;
    if (const std::size_t dash = caption.find('-'); dash != std::string::npos) caption[dash] = ' ';
    if (!caption.empty() && caption[0] >= 'a' && caption[0] <= 'z')
        caption[0] = static_cast<char>(caption[0] - 'a' + 'A');
    return caption;
}

void addResults(const StudyFacts& facts, ReportSection& section) {
    addTable(section, statisticsTable(facts.results));
    addTable(section, correlationTable(facts.results));
    addTable(section, oddCaseTable(facts.results));
    for (const StudyFigure& figure : facts.figures) addSvg(figure.svg, captionOf(figure.name), section);
    if (section.parts.empty()) addText(section, "No case has finished yet.");
}

void addStudyContent(const StudyFacts& facts, ReportContent content, ReportSection& section) {
    switch (content) {
        case ReportContent::Summary: return addStudySummary(facts, section);
        case ReportContent::Parameters: return addParameters(facts, section);
        case ReportContent::Results: return addResults(facts, section);
        default: return addCommonContent(facts.request, content, section);
    }
}

}  // namespace

}  // namespace report

ReportDocument studyReportOf(const Sweep& sweep, const SweepResults& results, const std::vector<StudyFigure>& figures,
                             const ReportRequest& request) {
    const report::StudyFacts facts{sweep, results, figures, request};
    const std::string own = sweep.study.title.empty() ? request.runName : sweep.study.title;
    return report::assembled(own, "Study", request, [&](ReportContent content, ReportSection& section) {
        report::addStudyContent(facts, content, section);
    });
}

}  // namespace keyblock
