// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/curve_entries.h"

#include "ui/picture/charts/history_charts.h"
#include "ui/picture/charts/history_series.h"
#include "ui/picture/charts/series_chart.h"

#include <QCoreApplication>

#include <algorithm>
#include <exception>
#include <iterator>

namespace keyblock {

namespace {

struct CurveTexts {
    Q_DECLARE_TR_FUNCTIONS(Curves)
};

constexpr double roundOff = 1e-9;

/// Joins the pieces of the first curve, which is split where values are missing.
void addPieces(CurveEntry& entry, const ChartPanel& panel) {
    for (const ChartCurve& piece : panel.curves) {
        if (piece.style != panel.curves.front().style) break;
        entry.x.insert(entry.x.end(), piece.x.begin(), piece.x.end());
        entry.y.insert(entry.y.end(), piece.y.begin(), piece.y.end());
    }
}

CurveEntry entryOf(const Chart& chart, const ChartPanel& panel, const QString& name) {
    CurveEntry entry;
    entry.name = name;
    entry.chart = chart;
    entry.chart.panels = {panel};
    addPieces(entry, panel);
    return entry;
}

std::vector<double> valuesOf(const RunSource& run, const Series& series, bool ofFrames) {
    return ofFrames ? keyblock::valuesOf(series, run.history(), run.frames()) : keyblock::valuesOf(series, run.history());
}

}  // namespace

CurveReading readCurves(const CurveOrder& order) {
    CurveReading reading{{}, {}, {}, {}, order.y, order.x, RunTime(*order.run)};
    try {
        reading.own = curveEntries(*order.run, order.kind);
        std::vector<CurveEntry> pinned;
        if (!order.tracks.empty()) pinned = pinEntries(*order.run, order.tracks);
        std::ranges::move(pinned, std::back_inserter(reading.own.entries));
        if (!order.y.empty()) reading.free = curveOver(*order.run, order.y, order.x);
        if (order.other) reading.other = curveEntries(*order.other, order.kind);
        if (order.other && !order.y.empty()) reading.otherFree = curveOver(*order.other, order.y, order.x);
    } catch (const std::exception& error) {
        reading.own = reading.free = {{}, QString::fromUtf8(error.what())};
    }
    return reading;
}

CurveEntries curveEntries(const RunSource& run, CurveKind kind) {
    const HistoryCharts charts = historyCharts(run, std::nullopt);
    CurveEntries found{{}, QString::fromStdString(charts.problem)};
    for (const Chart& chart : charts.charts)
        for (const ChartPanel& panel : chart.panels) {
            if (panel.curves.empty() || (kind == CurveKind::Energies) != panel.title.starts_with("Energy")) continue;
            QString name = QString::fromStdString(panel.title);
            if (!chart.overTime) name = CurveTexts::tr("%1 against %2").arg(name, QString::fromStdString(chart.xTitle));
            found.entries.push_back(entryOf(chart, panel, name));
        }
    return found;
}

CurveEntries curveOver(const RunSource& run, const std::string& y, const std::string& x) {
    const HistoryCharts charts = historyCharts(run, x.empty() ? y : y + " over " + x);
    CurveEntries found{{}, QString::fromStdString(charts.problem)};
    if (charts.charts.empty()) return found;
    const Chart& chart = charts.charts.front();
    CurveEntry entry = entryOf(chart, chart.panels.front(), {});
    if (!x.empty()) {
        const std::vector<Series> all = allSeries(run);
        const auto find = [&](const std::string& name) {
            return std::find_if(all.begin(), all.end(), [&](const Series& series) { return series.name == name; });
        };
        const auto of = find(y), over = find(x);
        if (of != all.end() && over != all.end()) {
            entry.ofFrames = of->energy || over->energy;
            entry.x = valuesOf(run, *over, entry.ofFrames);
            entry.y = valuesOf(run, *of, entry.ofFrames);
        }
    }
    found.entries.push_back(std::move(entry));
    return found;
}

QString pinEntryName(const Pin& pin) { return CurveTexts::tr("Pins: %1").arg(QString::fromStdString(titleOf(pin))); }

std::vector<CurveEntry> pinEntries(const RunSource& run, const std::vector<std::shared_ptr<const PinTrack>>& tracks) {
    std::vector<CurveEntry> entries;
    for (const Chart& chart : pinCharts(run, tracks)) {
        const QString title = QString::fromStdString(chart.panels.front().title);
        const auto same = std::count_if(entries.begin(), entries.end(), [&](const CurveEntry& entry) {
            return entry.chart.panels.front().title == chart.panels.front().title;
        });
        const QString name = same > 0 ? CurveTexts::tr("Pins, chart %1: %2").arg(same + 1).arg(title)
                                      : CurveTexts::tr("Pins: %1").arg(title);
        entries.push_back(entryOf(chart, chart.panels.front(), name));
    }
    return entries;
}

namespace {

/// Extends the axis of one run so that it also covers the other run.
std::vector<StageSpan> lengthened(std::vector<StageSpan> axis, const std::vector<StageSpan>& other) {
    for (const StageSpan& span : other) {
        StageSpan& last = axis.back();
        if (span.stage == last.stage && span.reached > last.reached && last.reached > 0.0) {
            last.to = last.from + (last.to - last.from) * span.reached / last.reached;
            last.reached = span.reached;
        } else if (span.stage > last.stage) {
            const double from = last.to;
            axis.push_back({span.stage, span.name, from, from + (span.to - span.from), span.reached});
        }
    }
    return axis;
}

/// A curve on the axis of another run: each point is moved to the same time of the same stage.
ChartCurve onAxis(ChartCurve curve, const std::vector<StageSpan>& own, const std::vector<StageSpan>& axis) {
    ChartCurve placed = curve;
    placed.x.clear();
    placed.y.clear();
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
        const StageMoment moment = momentAt(own, curve.x[i]);
        const auto span = std::find_if(axis.begin(), axis.end(),
                                       [&](const StageSpan& s) { return s.stage == moment.span->stage; });
        if (span == axis.end() || !(span->reached > 0.0) || moment.time > (1.0 + roundOff) * span->reached) continue;
        placed.x.push_back(span->from + (span->to - span->from) * moment.time / span->reached);
        placed.y.push_back(curve.y[i]);
    }
    return placed;
}

}  // namespace

void addOther(CurveEntry& shown, const CurveEntry& other, const QString& name) {
    ChartPanel& panel = shown.chart.panels.front();
    const std::vector<StageSpan>& others = other.chart.stages;
    const bool overTime = !shown.chart.stages.empty() && !others.empty();
    if (overTime) {
        shown.chart.stages = lengthened(shown.chart.stages, others);
        shown.chart.dividers.clear();
        for (const StageSpan& span : shown.chart.stages)
            if (span.from > 0.0) shown.chart.dividers.push_back(span.from);
    }
    for (ChartCurve curve : other.chart.panels.front().curves) {
        if (overTime) curve = onAxis(std::move(curve), others, shown.chart.stages);
        curve.ofOther = true;
        if (!curve.name.empty()) curve.name += CurveTexts::tr(", 2nd run").toStdString();
        panel.curves.push_back(std::move(curve));
    }
    const QString dashed = CurveTexts::tr("dashed: %1").arg(name);
    panel.note += (panel.note.empty() ? "" : "; ") + dashed.toStdString();
    ValueRange& x = shown.chart.x;
    x = overTime ? ValueRange{x.low, shown.chart.stages.back().to}
                 : ValueRange{std::min(x.low, other.chart.x.low), std::max(x.high, other.chart.x.high)};
    panel.range = {0.0, 0.0};
    for (const ChartLimit& limit : other.chart.panels.front().limits)
        if (panel.limits.empty()) panel.limits.push_back(limit);
    fitRange(panel);
}

}  // namespace keyblock
