// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/figure/bolt_figure.h"

#include "solver/results/csv.h"
#include "solver/results/tables.h"
#include "ui/figure/chart_painter.h"
#include "ui/figure/column.h"
#include "ui/figure/mark_painter.h"
#include "ui/figure/paper.h"
#include "ui/figure/sheet.h"
#include "ui/picture/charts/bolt_chart.h"
#include "ui/picture/not_finite.h"

#include <qcustomplot.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace keyblock {

namespace {

using namespace paper_theme;

constexpr double boltBandHeight = 6.0, boltPanelHeight = 26.0, boltAxisRoom = 10.0;  // [mm]
constexpr double boltMarkDistance = 1.45;  // [mm]

/// Chooses the frame and the bolt to show.
std::pair<std::size_t, int> chosen(const RunSource& run, const FigureRequest& request) {
    if (request.quantity)
        throw CannotDraw("a bolt figure shows all quantities; omit --quantity");
    const auto frame = frameAt(run, request.filter);
    if (!frame) throw CannotDraw("the run has no frames yet, so there is no bolt to show");
    const Frame values = run.frame(*frame);
    const int bolt = request.filter.bolt.value_or(mostLoadedBolt(values));
    if (bolt < 0) throw CannotDraw("no bolt is installed at this time");
    if (values.bolts[bolt].nodes.size() < 2)
        throw CannotDraw("bolt " + run.scene().bolts[bolt].name +
                         " is not installed at this time; choose another time with --at STAGE:TIME");
    return {*frame, bolt};
}

std::vector<MarkKind> kindsOf(const std::vector<Mark>& marks) {
    std::vector<MarkKind> kinds;
    for (const Mark& mark : marks)
        if (std::find(kinds.begin(), kinds.end(), mark.kind) == kinds.end()) kinds.push_back(mark.kind);
    std::sort(kinds.begin(), kinds.end());
    return kinds;
}

/// Draws the bolt itself, straightened, above the curves: shank, marks, and the labels of the far end and the head.
void drawBand(Ink& ink, const BoltChart& bolt, const std::vector<Mark>& marks, const ChartPlace& place, double y) {
    const auto at = [&](double s) { return Point(place.left + (place.right - place.left) * s / bolt.length, y); };
    ink.line(at(0.0), at(bolt.length), {0.7, rgb(0xA9AFB6)});
    const bool small = marks.size() > 24;
    for (const Mark& mark : marks) drawMark(ink, mark.kind, at(mark.s), {1.0, 0.0}, small);
    ink.text(at(0.0) + Point(-1.6, 0.7), "far end", text_style::note, Align::Right);
    ink.text(at(bolt.length) + Point(2.2, 0.7), "head", text_style::note);
}

/// Key to the kinds of marks and the envelope line, in as many rows as necessary.
class BoltKey {
public:
    BoltKey(const std::vector<MarkKind>& kinds, bool envelope, double width) {
        for (const MarkKind kind : kinds) add(kind, std::string(nameOf(kind)), 3.2, width);
        if (envelope) add(std::nullopt, "envelope to date", 6.0, width);
    }

    double height() const { return items_.empty() ? 0.0 : row * (items_.back().row + 1); }

    void draw(Ink& ink, double top) const {
        for (const Item& item : items_) {
            const double x = margin + item.x, y = top + row * item.row + 3.0;
            if (!item.kind) {
                ink.line({x, y - 0.7}, {x + 5.0, y - 0.7}, {0.17, rgb(0x8A93A0), {0.85, 0.5}});
            } else {
                const bool plate = *item.kind == MarkKind::Plate || *item.kind == MarkKind::PlateLost;
                drawMark(ink, *item.kind, {x + 1.2, y - 0.7}, plate ? Point(0.0, 1.0) : Point(1.0, 0.0));
            }
            ink.text({x + item.sample, y}, item.name, text_style::body);
        }
    }

private:
    static constexpr double row = 3.4;  // [mm]

    struct Item {
        std::optional<MarkKind> kind;  // null: the envelope line
        std::string name;
        double x, sample;  // [mm] distance from the margin, and offset of the name
        int row;
    };

    void add(std::optional<MarkKind> kind, const std::string& name, double sample, double width) {
        const double wide = sample + textWidth(name, text_style::body);
        if (next_ > 0.0 && next_ + wide > width) next_ = 0.0, ++row_;
        items_.push_back({kind, name, next_, sample, row_});
        next_ += wide + 3.3;
    }

    std::vector<Item> items_;
    double next_ = 0.0;
    int row_ = 0;
};

FigureData envelopeData(const BoltChart& bolt) {
    return {"-envelope", [envelopes = bolt.envelopes](std::ostream& out) {
                CsvWriter csv(out);
                csv.text("s_m");
                for (const Envelope& envelope : envelopes)
                    csv.text("least_" + envelope.quantity).text("largest_" + envelope.quantity);
                csv.endRow();
                for (std::size_t i = 0; !envelopes.empty() && i < envelopes.front().s.size(); ++i) {
                    csv.number(envelopes.front().s[i]);
                    for (const Envelope& envelope : envelopes) csv.number(envelope.low[i]).number(envelope.high[i]);
                    csv.endRow();
                }
            }};
}

FigureData tableData(const RunSource& run, std::size_t frame, int bolt) {
    TableFilter filter;
    filter.stage = run.frames()[frame].stage;
    filter.when = When::At;
    filter.time = run.frames()[frame].time;
    filter.bolt = bolt;
    return {"", [&run, filter](std::ostream& out) { writeTable(TableKind::Bolts, run, filter, out); }};
}

}  // namespace

Figure paintBolt(const RunSource& run, const FigureRequest& request) {
    const auto [frame, index] = chosen(run, request);
    BoltChart bolt = boltChart(run, frame, index);
    if (!request.title.empty()) bolt.title = request.title;
    const Sheet sheet(request.width, bolt.title, bolt.subtitle,
                      warningsOf(run, frame, notFiniteText(run.frame(frame))));
    const double chartHeight = boltPanelHeight * static_cast<double>(bolt.chart.panels.size()) + boltAxisRoom;
    // Which marks fit is known once the chart is drawn; until then space for all kinds is reserved.
    const BoltKey most(kindsOf(bolt.band), !bolt.envelopes.empty(), sheet.inner());
    const double height = std::ceil(sheet.heightAround(boltBandHeight + chartHeight + most.height() + 0.6));
    Paper paper(request.format, request.width, height, request.dpi, bolt.title);
    Ink ink(paper.painter());
    sheet.draw(ink, height, footOf(run, request, frame, height));
    const double top = sheet.top() + boltBandHeight;
    const ChartPlace place =
        drawChart(paper.painter(), bolt.chart, {{margin, top}, {request.width - margin, top + chartHeight}});
    const double perMetre = (place.right - place.left) / bolt.length;
    const std::vector<Mark> marks = thinned(bolt.band, boltMarkDistance / perMetre);
    drawBand(ink, bolt, marks, place, sheet.top() + 1.5);
    BoltKey(kindsOf(marks), !bolt.envelopes.empty(), sheet.inner()).draw(ink, top + chartHeight + 0.5);
    return {paper.finish(), {tableData(run, frame, index), envelopeData(bolt)}};
}

}  // namespace keyblock
