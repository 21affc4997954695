// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/figure/curves_figure.h"

#include "solver/results/tables.h"
#include "solver/results/result_names.h"
#include "ui/figure/chart_painter.h"
#include "ui/figure/paper.h"
#include "ui/figure/sheet.h"
#include "ui/picture/captions.h"
#include "ui/picture/charts/history_charts.h"
#include "ui/picture/run_time.h"

#include <qcustomplot.h>

#include <algorithm>
#include <cmath>

namespace keyblock {

namespace {

using namespace paper_theme;

constexpr double panelHeight = 30.0, axisRoom = 10.0, chartGap = 3.0, keyRoom = 3.0;  // [mm]

/// A panel with reference curves is higher, because it needs space for their key.
double heightOf(const Chart& chart) {
    double height = axisRoom;
    for (const ChartPanel& panel : chart.panels)
        height += panelHeight + (std::any_of(panel.curves.begin(), panel.curves.end(),
                                             [](const ChartCurve& curve) { return isReference(curve.style); })
                                     ? keyRoom
                                     : 0.0);
    return height;
}

std::string subtitleOf(const RunSource& run, const HistoryCharts& charts) {
    bool events = false;
    for (const Chart& chart : charts.charts) events = events || !chart.events.empty();
    std::string text;
    const RunTime time(run);
    for (const StageSpan& span : time.stages())
        text += (text.empty() ? "Stages: " : ", ") + stageName(run.scene(), span.stage);
    text += events ? ". Red lines: bolt events." : ".";
    std::string names;
    for (const std::string& name : charts.nothing) names += (names.empty() ? "" : ", ") + name;
    return text + (names.empty() ? "" : " Close to zero throughout, not drawn: " + names + ".");
}

std::vector<FigureData> dataOf(const RunSource& run, const FigureRequest& request) {
    std::vector<FigureData> data{
        {"", [&run](std::ostream& out) { writeTable(TableKind::History, run, {}, out); }},
        {"-energy", [&run](std::ostream& out) { writeTable(TableKind::Energy, run, {}, out); }}};
    for (std::size_t i = 0; i < request.references.size(); ++i) {
        const ReferenceTable& table = request.references[i];
        const std::string suffix = "-reference" + (i == 0 ? "" : "-" + std::to_string(i + 1));
        data.push_back({suffix, [&table](std::ostream& out) { writeReferenceTable(table, out); }});
    }
    return data;
}

}  // namespace

Figure paintCurves(const RunSource& run, const FigureRequest& request) {
    if (request.filter.bolt || request.filter.when || request.filter.stage)
        throw CannotDraw("curves show the whole run and its monitors; omit --bolt, --stage and --at");
    const HistoryCharts charts = historyCharts(run, request.quantity, request.references);
    if (charts.charts.empty()) throw CannotDraw(charts.problem);
    for (const Problem& problem : charts.references)
        if (problem.severity == Severity::Error)
            throw CannotDraw(problem.file + ": " + problem.message + ". " + problem.remedy);
    const std::string own = run.scene().title.empty() ? "History" : run.scene().title;
    const std::string title = request.title.empty() ? own : request.title;
    const Sheet sheet(request.width, title, subtitleOf(run, charts), warningsOf(run, std::nullopt));
    double content = -chartGap;
    for (const Chart& chart : charts.charts) content += heightOf(chart) + chartGap;
    const double height = std::ceil(sheet.heightAround(content));
    Paper paper(request.format, request.width, height, request.dpi, title);
    Ink ink(paper.painter());
    sheet.draw(ink, height, footOf(run, request, std::nullopt, height));
    double top = sheet.top();
    for (const Chart& chart : charts.charts) {
        drawChart(paper.painter(), chart, {{margin, top}, {request.width - margin, top + heightOf(chart)}});
        top += heightOf(chart) + chartGap;
    }
    return {paper.finish(), dataOf(run, request), charts.references};
}

}  // namespace keyblock
