// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/figure/chart_painter.h"

#include "solver/results/reference_table.h"
#include "ui/figure/application.h"
#include "ui/figure/chart_pens.h"
#include "ui/figure/chart_tickers.h"
#include "ui/figure/paper.h"

#include <qcustomplot.h>

#include <algorithm>
#include <cmath>

namespace keyblock {

namespace {

constexpr double keySample = 6.0, keyGap = 3.0, keyRow = 2.8;  // [mm]
constexpr double numbersFrom = 2.3, mostOfTitle = 14.0;  // [mm] space next to numbers, largest width of a title
constexpr double leastTickRow = 1.9, titleRim = 0.8;  // [mm]
constexpr double belowNote = 0.6;  // [mm] from the top of a panel to the names that do not reach into the note above it
constexpr std::size_t mostMarks = 60;  // reference curves with more points have no marks

/// Draws without clipping: SVG cannot clip, and all formats should look alike. A dot on an axis is drawn whole.
template <class Plottable>
class Unclipped : public Plottable {
public:
    using Plottable::Plottable;

protected:
    QRect clipRect() const override { return this->parentPlot()->viewport(); }
};

TextStyle inked(TextStyle style, const Colour& colour) {
    style.colour = colour;
    return style;
}

class ChartPainter {
public:
    ChartPainter(const Chart& chart, const Point& size, const ChartTheme& theme, const ChartLayout& layout)
        : chart_(chart), theme_(theme), layout_(layout), size_(size), keyRoom_(size.x() - 16.0) {
        plot_.plotLayout()->clear();
        plot_.setBackground(Qt::NoBrush);
        plot_.plotLayout()->setRowSpacing(unitsOf(layout.panelGap));
        makeRoomForTitles();
        auto* group = new QCPMarginGroup(&plot_);
        for (std::size_t i = 0; i < chart.panels.size(); ++i) addPanel(i, group);
    }

    ChartPlace draw(QCPPainter& painter, const Box& box) {
        const Point size = box.max - box.min;
        plot_.setViewport(QRect(0, 0, unitsOf(size.x()), unitsOf(size.y())));
        keepNumbersApart();
        plot_.replot(QCustomPlot::rpImmediateRefresh);
        painter.save();
        painter.translate(box.min.x() * unitsPerMm, box.min.y() * unitsPerMm);
        drawZones(painter);
        plot_.toPainter(&painter, unitsOf(size.x()), unitsOf(size.y()));
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
    /// Titles next to the panels are placed to the left of the widest number of all panels.
    void makeRoomForTitles() {
        for (const ChartPanel& panel : chart_.panels) {
            const Ticks ticks = roundTicks(panel.range, layout_.mostTicks);
            for (const double value : ticks.values)
                titlesFrom_ = std::max(titlesFrom_, numbersFrom + textWidth(numberText(value, ticks.decimals), text_style::tick));
            const Title parted = partedTitle(panel.title);
            for (const auto& [text, style] : {std::pair(parted.name, text_style::number), std::pair(parted.unit, text_style::note)})
                titlesWidth_ = std::min(mostOfTitle, std::max(titlesWidth_, textWidth(text, style)));
        }
    }

    /// Prevents the numbers of a low panel from overlapping; the height of a panel is known only once the layout is
    /// done.
    void keepNumbersApart() {
        using Element = QCPLayoutElement;
        for (const auto phase : {Element::upPreparation, Element::upMargins, Element::upLayout})
            plot_.plotLayout()->update(phase);
        for (std::size_t i = 0; i < rects_.size(); ++i)
            tickers_[i]->setLeast(unitsOf(leastTickRow) / std::max(1.0, double(rects_[i]->height())));
    }

    void styleAxis(QCPAxis* axis, bool labels) const {
        axis->setBasePen(chartPen(0.15, theme_.axis));
        axis->setTickPen(chartPen(0.15, theme_.axis));
        axis->setSubTicks(false);
        axis->setTickLengthIn(0);
        axis->setTickLengthOut(labels ? unitsOf(0.7) : 0);
        axis->setTickLabels(labels);
        axis->setTickLabelFont(fontOf(text_style::tick));
        axis->setTickLabelColor(inkOf(theme_.softText));
        axis->setTickLabelPadding(unitsOf(0.6));
        axis->setLabelFont(fontOf(text_style::body));
        axis->setLabelColor(inkOf(theme_.text));
        axis->setLabelPadding(unitsOf(0.7));
        axis->setPadding(0);
        axis->grid()->setPen(chartPen(0.13, theme_.grid));
        axis->grid()->setZeroLinePen(chartPen(0.15, theme_.axis));
    }

    void addPanel(std::size_t index, QCPMarginGroup* group) {
        const ChartPanel& panel = chart_.panels[index];
        const bool last = index + 1 == chart_.panels.size();
        auto* rect = new QCPAxisRect(&plot_, false);
        rect->addAxis(QCPAxis::atBottom);
        rect->addAxis(QCPAxis::atLeft);
        plot_.plotLayout()->addElement(static_cast<int>(index), 0, rect);
        rect->setMarginGroup(QCP::msLeft | QCP::msRight, group);
        const double title = layout_.titlesBeside ? 0.8 : 1.4;
        const double left = std::max(layout_.leftRoom, layout_.titlesBeside ? titlesFrom_ + titlesWidth_ + titleRim : 0.0);
        const double above = (index == 0 ? 1.2 + title : 1.2) + keyRow * keyRowsOf(panel), below = last ? 2.0 : 0.6;
        rect->setMinimumMargins(
            QMargins(unitsOf(left), unitsOf(above), unitsOf(layout_.rightRoom), unitsOf(below)));
        rects_.push_back(rect);
        QCPAxis* x = rect->axis(QCPAxis::atBottom);
        QCPAxis* y = rect->axis(QCPAxis::atLeft);
        styleAxis(x, last);
        styleAxis(y, true);
        x->grid()->setVisible(false);
        const double length = size_.x() - left - layout_.rightRoom;
        x->setTicker(chart_.isStaged() ? QSharedPointer<QCPAxisTicker>(new StageTicker(chart_, length))
                                       : QSharedPointer<QCPAxisTicker>(new RoundTicker(8)));
        tickers_.push_back(QSharedPointer<RoundTicker>(new RoundTicker(layout_.mostTicks)));
        y->setTicker(tickers_.back());
        x->setRange(chart_.x.low, chart_.x.high);
        y->setRange(panel.range.low, panel.range.high);
        if (last) x->setLabel(QString::fromStdString(elided(chart_.xTitle, text_style::body, keyRoom_ - 10.0, true)));
        for (const double place : chart_.dividers)
            addVertical(x, y, place, chartPen(0.17, theme_.softText, {1.0, 2.0}));
        for (const double place : chart_.events) addVertical(x, y, place, chartPen(0.1, theme_.event));
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
        const QPen line = limit.ultimate ? chartPen(0.2, theme_.limit, {6.0, 3.0})
                                         : chartPen(0.2, theme_.softText, {1.5, 2.5});
        if (limit.x.empty()) addLine(x, y, {x->range().lower, x->range().upper}, {limit.value, limit.value}, line);
        else
            addLine(x, y, QVector<double>(limit.x.begin(), limit.x.end()),
                    QVector<double>(limit.y.begin(), limit.y.end()), line);
    }

    void addCurve(QCPAxis* x, QCPAxis* y, const ChartCurve& curve) {
        if (curve.style == CurveStyle::Stems) {
            for (std::size_t i = 0; i < curve.x.size(); ++i)
                if (canBeShown(curve.x[i]) && canBeShown(curve.y[i]))
                    addLine(x, y, {curve.x[i], curve.x[i]}, {0.0, curve.y[i]}, penOf(theme_, curve));
            auto* dots = new Unclipped<QCPGraph>(x, y);
            dots->setData(shownOf(curve.x), shownOf(curve.y));
            dots->setLineStyle(QCPGraph::lsNone);
            dots->setScatterStyle(
                QCPScatterStyle(QCPScatterStyle::ssDisc, inkOf(colourOf(theme_, curve.style)), unitsOf(0.9)));
            return;
        }
        addLine(x, y, shownOf(curve.x), shownOf(curve.y), penOf(theme_, curve));
    }

    /// The values, with NaN, where the chart has a gap, for those that cannot be shown.
    static QVector<double> shownOf(const std::vector<double>& values) {
        QVector<double> shown(values.begin(), values.end());
        std::replace_if(
            shown.begin(), shown.end(), [](double value) { return !canBeShown(value); }, std::nan(""));
        return shown;
    }

    void drawZones(QCPPainter& painter) const {
        for (const ChartZone& zone : chart_.zones)
            for (const QCPAxisRect* rect : rects_) {
                const QCPAxis* x = const_cast<QCPAxisRect*>(rect)->axis(QCPAxis::atBottom);
                const double left = x->coordToPixel(zone.from), right = x->coordToPixel(zone.to);
                painter.fillRect(QRectF(left, rect->top(), right - left, rect->height()), inkOf(theme_.zone, 0.11));
            }
    }

    struct KeyEntry {
        const ChartCurve* curve;
        std::string name;
        double x = 0.0;  // [mm] distance from the left
        int row = 0;
    };

    /// Key entries of the reference curves, one after the other, in rows.
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

    /// Draws a sample of each reference curve, with its mark and name, between the panel's title and the panel.
    void drawKey(Ink& ink, std::size_t index) const {
        const ChartPanel& panel = chart_.panels[index];
        const Point corner(rects_[index]->left() / unitsPerMm,
                           rects_[index]->top() / unitsPerMm - 0.9 - keyRow * (keyRowsOf(panel) - 1));
        for (const KeyEntry& entry : keyOf(panel)) {
            const Point at = corner + Point(entry.x, keyRow * entry.row);
            Stroke line{referenceLine, colourOf(theme_, entry.curve->style), dashesOf(entry.curve->style)};
            for (double& dash : line.dashes) dash *= referenceLine;
            ink.line(at + Point(0.0, -0.7), at + Point(keySample, -0.7), line);
            if (entry.curve->x.size() <= mostMarks)
                drawMark(ink, theme_, entry.curve->style, at + Point(0.5 * keySample, -0.7));
            ink.text(at + Point(keySample + 1.0, 0.0), entry.name,
                     inked(text_style::tick, theme_.text));
        }
    }

    void markReferences(Ink& ink, std::size_t index) const {
        const QCPAxis* x = rects_[index]->axis(QCPAxis::atBottom);
        const QCPAxis* y = rects_[index]->axis(QCPAxis::atLeft);
        for (const ChartCurve& curve : chart_.panels[index].curves) {
            if (!isReference(curve.style) || curve.x.size() > mostMarks) continue;
            for (std::size_t i = 0; i < curve.x.size(); ++i)
                drawMark(ink, theme_, curve.style,
                         {x->coordToPixel(curve.x[i]) / unitsPerMm, y->coordToPixel(curve.y[i]) / unitsPerMm});
        }
    }

    void nameAbove(Ink& ink, const ChartPanel& panel, const QCPAxisRect& rect) const {
        const Point at(rect.left() / unitsPerMm, rect.top() / unitsPerMm - 0.9 - keyRow * keyRowsOf(panel));
        ink.text(at, panel.title, inked(text_style::number, theme_.text));
        const double from = textWidth(panel.title, text_style::number) + 2.0;
        ink.text(at + Point(from, 0.0), elided(panel.note, text_style::note, size_.x() - at.x() - from - 0.5, true),
                 inked(text_style::note, theme_.softText));
    }

    void nameBeside(Ink& ink, const ChartPanel& panel, const QCPAxisRect& rect) const {
        const Point at(rect.left() / unitsPerMm - titlesFrom_, (rect.top() + 0.5 * rect.height()) / unitsPerMm);
        const Title parted = partedTitle(panel.title);
        ink.text(at, elided(parted.name, text_style::number, titlesWidth_ + 0.01), inked(text_style::number, theme_.text),
                 Align::Right);
        ink.text(at + Point(0.0, 2.6), parted.unit, inked(text_style::note, theme_.softText), Align::Right);
    }

    /// Draws the panel's title, and the names of limits and curves at their right ends, moved apart where they would
    /// overlap.
    void nameEnds(Ink& ink, std::size_t index) const {
        const ChartPanel& panel = chart_.panels[index];
        QCPAxisRect* rect = rects_[index];
        const QCPAxis* y = rect->axis(QCPAxis::atLeft);
        if (layout_.titlesBeside) nameBeside(ink, panel, *rect);
        else nameAbove(ink, panel, *rect);
        struct End {
            double y;
            std::string name;
            Colour colour;
        };
        std::vector<End> ends;
        for (const ChartLimit& limit : panel.limits)
            if (!limit.name.empty())
                ends.push_back({y->coordToPixel(limit.value) / unitsPerMm, limit.name,
                                limit.ultimate ? theme_.limit : theme_.softText});
        for (const ChartCurve& curve : panel.curves)
            if (!curve.name.empty() && !curve.y.empty() && !isReference(curve.style))
                ends.push_back(
                    {y->coordToPixel(curve.y.back()) / unitsPerMm, curve.name, colourOf(theme_, curve.style)});
        std::stable_sort(ends.begin(), ends.end(), [](const End& a, const End& b) { return a.y < b.y; });
        const double row = 2.5, bottom = (rect->top() + rect->height()) / unitsPerMm;
        double free = rect->top() / unitsPerMm + (layout_.titlesBeside ? 0.0 : belowNote);
        double rest = row * static_cast<double>(ends.size());
        for (const End& end : ends) {
            const double place = std::max(free, std::min(end.y, bottom - rest + 0.5 * row));
            TextStyle style = text_style::tick;
            style.colour = end.colour;
            ink.text({(rect->left() + rect->width()) / unitsPerMm + 1.0, place + 0.7},
                     elided(end.name, style, layout_.rightRoom - 1.5, true), style);
            free = place + row;
            rest -= row;
        }
    }

    ChartPlace placeIn(const Box& box) const {
        const QCPAxisRect *first = rects_.front(), *last = rects_.back();
        ChartPlace place{box.min.x() + first->left() / unitsPerMm,
                         box.min.x() + (first->left() + first->width()) / unitsPerMm,
                         box.min.y() + first->top() / unitsPerMm,
                         box.min.y() + (last->top() + last->height()) / unitsPerMm};
        for (const QCPAxisRect* rect : rects_)
            place.panels.push_back({box.min.y() + rect->top() / unitsPerMm,
                                    box.min.y() + (rect->top() + rect->height()) / unitsPerMm});
        return place;
    }

    const Chart& chart_;
    const ChartTheme& theme_;
    const ChartLayout& layout_;
    Point size_;  // [mm]
    double keyRoom_;  // [mm]
    double titlesFrom_ = 6.5, titlesWidth_ = 0.0;  // [mm] distance of titles at the left, and their width
    QCustomPlot plot_;
    std::vector<QCPAxisRect*> rects_;
    std::vector<QSharedPointer<RoundTicker>> tickers_;  // of the ordinates
};

}  // namespace

ChartPlace drawChart(QCPPainter& painter, const Chart& chart, const Box& box, const ChartTheme& theme,
                     const ChartLayout& layout) {
    needApplication();
    return ChartPainter(chart, box.max - box.min, theme, layout).draw(painter, box);
}

}  // namespace keyblock
