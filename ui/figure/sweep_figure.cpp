// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/figure/sweep_figure.h"

#include "ui/figure/paper.h"
#include "ui/figure/sheet.h"
#include "ui/figure/sweep_plot.h"

#include <qcustomplot.h>

#include <cmath>

namespace keyblock {

namespace {

constexpr double sweepPlotHeight = 77.0;  // [mm]
constexpr const char* sweepFoot = "Keyblock · keyblock sweep";

/// Draws a plot of this height on paper: sheet, then what `draw` adds to an area.
template <typename Chart, typename Draw>
std::string onPaper(const Chart& chart, PaperFormat format, double width, double height, Draw draw) {
    const Sheet sheet(width, chart.title, chart.subtitle, {});
    const double whole = std::ceil(sheet.heightAround(height));
    Paper paper(format, width, whole, 300, chart.title);
    Ink ink(paper.painter());
    sheet.draw(ink, whole, sweepFoot);
    const double margin = paper_theme::margin;
    draw(ink, chart, Box{{margin, sheet.top()}, {width - margin, sheet.top() + height}}, paperSweepTheme());
    return paper.finish();
}

}  // namespace

std::string paintHistogram(const HistogramChart& chart, PaperFormat format, double width) {
    if (chart.sorted.empty()) throw CannotDraw("there are no values");
    return onPaper(chart, format, width, sweepPlotHeight, drawHistogram);
}

std::string paintScatter(const ScatterChart& chart, PaperFormat format, double width) {
    if (chart.dots.empty()) throw CannotDraw("no case has both values");
    return onPaper(chart, format, width, sweepPlotHeight, drawScatter);
}

std::string paintTornado(const TornadoChart& chart, PaperFormat format, double width) {
    if (chart.bars.empty()) throw CannotDraw("nothing varies");
    return onPaper(chart, format, width, tornadoHeight(chart), drawTornado);
}

std::string paintConvergence(const ConvergenceChart& chart, PaperFormat format, double width) {
    if (chart.points.empty()) throw CannotDraw("no case is decided");
    return onPaper(chart, format, width, sweepPlotHeight, drawConvergence);
}

}  // namespace keyblock
