// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/figure/chart_ink.h"

#include "ui/figure/application.h"
#include "ui/figure/paper.h"

#include <qcustomplot.h>

#include <algorithm>
#include <cmath>

namespace keyblock {

namespace {

using namespace paper_theme;

constexpr double panelGap = 3.2, rightRoom = 17.0;  // [mm]
constexpr double keySample = 6.0, keyGap = 3.0, keyRow = 2.8;  // [mm]
constexpr std::size_t mostMarks = 60;  // of a reference: more points are a line alone

int units(double mm) { return static_cast<int>(std::lround(mm * unitsPerMm)); }
QColor qt(const Colour& colour, double opacity = 1.0) {
    QColor result(colour.red, colour.green, colour.blue);
    result.setAlphaF(opacity);
    return result;
}
QPen pen(double width, const Colour& colour, const QVector<qreal>& dashes = {}) {
    QPen result(qt(colour), width * unitsPerMm);
    if (!dashes.empty()) result.setDashPattern(dashes);
    result.setCapStyle(dashes.empty() ? Qt::RoundCap : Qt::FlatCap);
    result.setJoinStyle(Qt::RoundJoin);
    return result;
}

/// Our round numbers in place of QCustomPlot's, with a true minus.
class RoundTicker : public QCPAxisTicker {
public:
    explicit RoundTicker(int most) : most_(most) {}
    void generate(const QCPRange& range, const QLocale&, QChar, int, QVector<double>& ticks, QVector<double>* subTicks,
                  QVector<QString>* labels) override {
        const Ticks round = roundTicks({range.lower, range.upper}, most_);
        ticks = QVector<double>(round.values.begin(), round.values.end());
        if (subTicks) subTicks->clear();
        if (!labels) return;
        labels->clear();
        for (const double value : round.values)
            labels->append(QString::fromStdString(numberText(value, round.decimals)));
    }

private:
    int most_;
};

/// SVG cannot clip, and all formats are to be alike; a dot on the axis stays whole.
template <class Plottable>
class Unclipped : public Plottable {
public:
    using Plottable::Plottable;

protected:
    QRect clipRect() const override { return this->parentPlot()->viewport(); }
};

Colour colourOf(CurveStyle style) {
    switch (style) {
        case CurveStyle::Main:
        case CurveStyle::Stems: return paper_theme::ribbon;
        case CurveStyle::Second: return rgb(0xB63100);
        case CurveStyle::Third: return rgb(0x1B7F55);
        case CurveStyle::Fourth: return rgb(0x4A5260);
        case CurveStyle::Reference: return rgb(0x111111);
        case CurveStyle::SecondReference: return rgb(0x8A5A00);
        case CurveStyle::ThirdReference: return rgb(0x7A2E7A);
        case CurveStyle::FourthReference: return rgb(0x2B6E8F);
        case CurveStyle::Envelope: break;
    }
    return rgb(0x8A93A0);
}

/// In widths of the line; empty: solid.
std::vector<double> dashesOf(CurveStyle style) {
    switch (style) {
        case CurveStyle::Reference: return {5.0, 3.0};
        case CurveStyle::SecondReference: return {9.0, 3.0};
        case CurveStyle::ThirdReference: return {2.0, 2.5};
        case CurveStyle::FourthReference: return {9.0, 3.0, 2.0, 3.0};
        default: return {};
    }
}

constexpr double referenceLine = 0.25;  // [mm]

/// Each reference has a mark of its own.
void drawMark(Ink& ink, CurveStyle style, const Point& at) {
    const double r = 0.65;
    const Stroke line{0.17, colourOf(style)};
    const auto outline = [&](std::vector<Point> points) {
        for (Point& point : points) point = at + r * point;
        ink.polygon(points, white, line);
    };
    switch (style) {
        case CurveStyle::SecondReference: return outline({{-0.9, -0.9}, {0.9, -0.9}, {0.9, 0.9}, {-0.9, 0.9}});
        case CurveStyle::ThirdReference: return outline({{0.0, -1.1}, {1.0, 0.8}, {-1.0, 0.8}});
        case CurveStyle::FourthReference: return outline({{0.0, -1.2}, {1.2, 0.0}, {0.0, 1.2}, {-1.2, 0.0}});
        default: ink.circle(at, r, white, line);
    }
}

QPen penOf(CurveStyle style) {
    if (isReference(style)) {
        const std::vector<double> dashes = dashesOf(style);
        return pen(referenceLine, colourOf(style), QVector<qreal>(dashes.begin(), dashes.end()));
    }
    switch (style) {
        case CurveStyle::Envelope: return pen(0.17, colourOf(style), {5.0, 3.0});
        case CurveStyle::Stems: return pen(0.3, colourOf(style));
        case CurveStyle::Third: return pen(0.3, colourOf(style), {6.0, 2.5});
        case CurveStyle::Fourth: return pen(0.3, colourOf(style), {1.5, 2.5});
        default: return pen(0.3, colourOf(style));
    }
}

class ChartPainter {
public:
    ChartPainter(const Chart& chart, double width) : chart_(chart), keyRoom_(width - 16.0) {
        plot_.plotLayout()->clear();
        plot_.setBackground(Qt::NoBrush);
        plot_.plotLayout()->setRowSpacing(units(panelGap));
        auto* group = new QCPMarginGroup(&plot_);
        for (std::size_t i = 0; i < chart.panels.size(); ++i) addPanel(i, group);
    }

    ChartPlace draw(QCPPainter& painter, const Box& box) {
        const Point size = box.max - box.min;
        plot_.setViewport(QRect(0, 0, units(size.x()), units(size.y())));
        plot_.replot(QCustomPlot::rpImmediateRefresh);
        painter.save();
        painter.translate(box.min.x() * unitsPerMm, box.min.y() * unitsPerMm);
        drawZones(painter);
        plot_.toPainter(&painter, units(size.x()), units(size.y()));
        Ink ink(painter);
        for (std::size_t i = 0; i < chart_.panels.size(); ++i) {
            markReferences(ink, i);
            nameEnds(ink, i);
            drawKey(ink, i);
        }
        painter.restore();
        return placeIn(box);
    }

private:
    void styleAxis(QCPAxis* axis, bool labels) const {
        axis->setBasePen(pen(0.15, paper_theme::axis));
        axis->setTickPen(pen(0.15, paper_theme::axis));
        axis->setSubTicks(false);
        axis->setTickLengthIn(0);
        axis->setTickLengthOut(labels ? units(0.7) : 0);
        axis->setTickLabels(labels);
        axis->setTickLabelFont(fontOf(text_style::tick));
        axis->setTickLabelColor(qt(softText));
        axis->setTickLabelPadding(units(0.6));
        axis->setLabelFont(fontOf(text_style::body));
        axis->setLabelColor(qt(black));
        axis->setLabelPadding(units(0.7));
        axis->setPadding(0);
        axis->grid()->setPen(pen(0.13, paper_theme::grid));
        axis->grid()->setZeroLinePen(pen(0.15, paper_theme::axis));
    }

    void addPanel(std::size_t index, QCPMarginGroup* group) {
        const ChartPanel& panel = chart_.panels[index];
        const bool last = index + 1 == chart_.panels.size();
        auto* rect = new QCPAxisRect(&plot_, false);
        rect->addAxis(QCPAxis::atBottom);
        rect->addAxis(QCPAxis::atLeft);
        plot_.plotLayout()->addElement(static_cast<int>(index), 0, rect);
        rect->setMarginGroup(QCP::msLeft | QCP::msRight, group);
        const double above = (index == 0 ? 2.6 : 1.2) + keyRow * keyRowsOf(panel), below = last ? 2.0 : 0.6;
        rect->setMinimumMargins(QMargins(units(9.0), units(above), units(rightRoom), units(below)));
        rects_.push_back(rect);
        QCPAxis* x = rect->axis(QCPAxis::atBottom);
        QCPAxis* y = rect->axis(QCPAxis::atLeft);
        styleAxis(x, last);
        styleAxis(y, true);
        x->grid()->setVisible(false);
        x->setTicker(QSharedPointer<QCPAxisTicker>(new RoundTicker(8)));
        y->setTicker(QSharedPointer<QCPAxisTicker>(new RoundTicker(mostPanelTicks)));
        x->setRange(chart_.x.low, chart_.x.high);
        y->setRange(panel.range.low, panel.range.high);
        if (last) x->setLabel(QString::fromStdString(elided(chart_.xTitle, text_style::body, keyRoom_ - 10.0, true)));
        for (const double place : chart_.dividers) addVertical(x, y, place, pen(0.17, softText, {1.0, 2.0}));
        for (const double place : chart_.events) addVertical(x, y, place, pen(0.1, rgb(0xC9A3A6)));
        for (const ChartLimit& limit : panel.limits) addLimit(x, y, limit);
        for (const ChartCurve& curve : panel.curves) addCurve(x, y, curve);
    }

    void addLine(QCPAxis* x, QCPAxis* y, const QVector<double>& xs, const QVector<double>& ys, const QPen& line) {
        auto* curve = new Unclipped<QCPCurve>(x, y);
        curve->setData(xs, ys);
        curve->setPen(line);
    }

    void addVertical(QCPAxis* x, QCPAxis* y, double place, const QPen& line) {
        addLine(x, y, {place, place}, {y->range().lower, y->range().upper}, line);
    }

    void addLimit(QCPAxis* x, QCPAxis* y, const ChartLimit& limit) {
        const QPen line = limit.ultimate ? pen(0.2, error, {6.0, 3.0}) : pen(0.2, softText, {1.5, 2.5});
        if (limit.x.empty()) addLine(x, y, {x->range().lower, x->range().upper}, {limit.value, limit.value}, line);
        else
            addLine(x, y, QVector<double>(limit.x.begin(), limit.x.end()),
                    QVector<double>(limit.y.begin(), limit.y.end()), line);
    }

    void addCurve(QCPAxis* x, QCPAxis* y, const ChartCurve& curve) {
        if (curve.style == CurveStyle::Stems) {
            for (std::size_t i = 0; i < curve.x.size(); ++i)
                addLine(x, y, {curve.x[i], curve.x[i]}, {0.0, curve.y[i]}, penOf(curve.style));
            auto* dots = new Unclipped<QCPGraph>(x, y);
            dots->setData(QVector<double>(curve.x.begin(), curve.x.end()),
                          QVector<double>(curve.y.begin(), curve.y.end()));
            dots->setLineStyle(QCPGraph::lsNone);
            dots->setScatterStyle(
                QCPScatterStyle(QCPScatterStyle::ssDisc, qt(colourOf(curve.style)), units(0.9)));
            return;
        }
        addLine(x, y, QVector<double>(curve.x.begin(), curve.x.end()), QVector<double>(curve.y.begin(), curve.y.end()),
                penOf(curve.style));
    }

    void drawZones(QCPPainter& painter) const {
        for (const ChartZone& zone : chart_.zones)
            for (const QCPAxisRect* rect : rects_) {
                const QCPAxis* x = const_cast<QCPAxisRect*>(rect)->axis(QCPAxis::atBottom);
                const double left = x->coordToPixel(zone.from), right = x->coordToPixel(zone.to);
                painter.fillRect(QRectF(left, rect->top(), right - left, rect->height()), qt(slipping, 0.11));
            }
    }

    struct KeyEntry {
        const ChartCurve* curve;
        std::string name;
        double x = 0.0;  // from the left [mm]
        int row = 0;
    };

    /// References one after the other, in rows.
    std::vector<KeyEntry> keyOf(const ChartPanel& panel) const {
        std::vector<KeyEntry> entries;
        double x = 0.0;
        int row = 0;
        for (const ChartCurve& curve : panel.curves) {
            if (!isReference(curve.style)) continue;
            const std::string name = elided(curve.name, text_style::tick, keyRoom_ - keySample - 1.0, true);
            const double width = keySample + 1.0 + textWidth(name, text_style::tick);
            if (x > 0.0 && x + width > keyRoom_) x = 0.0, ++row;
            entries.push_back({&curve, name, x, row});
            x += width + keyGap;
        }
        return entries;
    }

    int keyRowsOf(const ChartPanel& panel) const {
        const std::vector<KeyEntry> entries = keyOf(panel);
        return entries.empty() ? 0 : entries.back().row + 1;
    }

    /// A line and a mark of each reference, with its name, between the panel's title and the panel.
    void drawKey(Ink& ink, std::size_t index) const {
        const ChartPanel& panel = chart_.panels[index];
        const Point corner(rects_[index]->left() / unitsPerMm,
                           rects_[index]->top() / unitsPerMm - 0.9 - keyRow * (keyRowsOf(panel) - 1));
        for (const KeyEntry& entry : keyOf(panel)) {
            const Point at = corner + Point(entry.x, keyRow * entry.row);
            Stroke line{referenceLine, colourOf(entry.curve->style), dashesOf(entry.curve->style)};
            for (double& dash : line.dashes) dash *= referenceLine;
            ink.line(at + Point(0.0, -0.7), at + Point(keySample, -0.7), line);
            if (entry.curve->x.size() <= mostMarks)
                drawMark(ink, entry.curve->style, at + Point(0.5 * keySample, -0.7));
            ink.text(at + Point(keySample + 1.0, 0.0), entry.name, text_style::tick);
        }
    }

    void markReferences(Ink& ink, std::size_t index) const {
        const QCPAxis* x = rects_[index]->axis(QCPAxis::atBottom);
        const QCPAxis* y = rects_[index]->axis(QCPAxis::atLeft);
        for (const ChartCurve& curve : chart_.panels[index].curves) {
            if (!isReference(curve.style) || curve.x.size() > mostMarks) continue;
            for (std::size_t i = 0; i < curve.x.size(); ++i)
                drawMark(ink, curve.style,
                         {x->coordToPixel(curve.x[i]) / unitsPerMm, y->coordToPixel(curve.y[i]) / unitsPerMm});
        }
    }

    /// The panel's title above it, and names at the right ends of limits and curves, pushed apart where they meet.
    void nameEnds(Ink& ink, std::size_t index) const {
        const ChartPanel& panel = chart_.panels[index];
        QCPAxisRect* rect = rects_[index];
        const QCPAxis* y = rect->axis(QCPAxis::atLeft);
        const Point at(rect->left() / unitsPerMm, rect->top() / unitsPerMm - 0.9 - keyRow * keyRowsOf(panel));
        ink.text(at, panel.title, text_style::number);
        ink.text(at + Point(textWidth(panel.title, text_style::number) + 2.0, 0.0), panel.note, text_style::note);
        struct End {
            double y;
            std::string name;
            Colour colour;
        };
        std::vector<End> ends;
        for (const ChartLimit& limit : panel.limits)
            if (!limit.name.empty())
                ends.push_back(
                    {y->coordToPixel(limit.value) / unitsPerMm, limit.name, limit.ultimate ? error : softText});
        for (const ChartCurve& curve : panel.curves)
            if (!curve.name.empty() && !curve.y.empty() && !isReference(curve.style))
                ends.push_back({y->coordToPixel(curve.y.back()) / unitsPerMm, curve.name, colourOf(curve.style)});
        std::stable_sort(ends.begin(), ends.end(), [](const End& a, const End& b) { return a.y < b.y; });
        const double row = 2.5, bottom = (rect->top() + rect->height()) / unitsPerMm;
        double free = rect->top() / unitsPerMm;
        double rest = row * static_cast<double>(ends.size());
        for (const End& end : ends) {
            const double place = std::max(free, std::min(end.y, bottom - rest + 0.5 * row));
            TextStyle style = text_style::tick;
            style.colour = end.colour;
            ink.text({(rect->left() + rect->width()) / unitsPerMm + 1.0, place + 0.7},
                     elided(end.name, style, rightRoom - 1.5, true), style);
            free = place + row;
            rest -= row;
        }
    }

    ChartPlace placeIn(const Box& box) const {
        const QCPAxisRect *first = rects_.front(), *last = rects_.back();
        return {box.min.x() + first->left() / unitsPerMm,
                box.min.x() + (first->left() + first->width()) / unitsPerMm, box.min.y() + first->top() / unitsPerMm,
                box.min.y() + (last->top() + last->height()) / unitsPerMm};
    }

    const Chart& chart_;
    double keyRoom_;  // [mm]
    QCustomPlot plot_;
    std::vector<QCPAxisRect*> rects_;
};

}  // namespace

ChartPlace drawChart(QCPPainter& painter, const Chart& chart, const Box& box) {
    needApplication();
    return ChartPainter(chart, box.max.x() - box.min.x()).draw(painter, box);
}

}  // namespace keyblock
