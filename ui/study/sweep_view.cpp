// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/study/sweep_view.h"

#include "ui/figure/paper.h"
#include "ui/figure/sweep_plot.h"
#include "ui/look/display.h"
#include "ui/look/qt_text.h"
#include "ui/look/theme.h"

#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>

#include <cmath>

namespace keyblock {

namespace {

constexpr double sweepPixelsPerMm = 5.25;  // so that letters 2 mm high in figures have 10.5 px here
constexpr double clickReach = 7.0;  // [px]
constexpr int leastChartWidth = 220, leastChartHeight = 130;  // [px]

Colour sweepColour(const QColor& colour) { return rgb(static_cast<std::uint32_t>(colour.rgb() & 0xFFFFFF)); }

SweepTheme sweepThemeOf(const Theme& theme) {
    SweepTheme made = paperSweepTheme();
    made.ground = sweepColour(theme.panel);
    made.text = sweepColour(theme.text);
    made.axis = sweepColour(theme.border);
    made.grid = sweepColour(theme.chartGrid);
    made.dots = sweepColour(theme.accent);
    made.marked = sweepColour(theme.error);
    made.band = sweepColour(theme.accentRow);
    if (theme.dark) made.curve = rgb(0xF08A4B);
    return made;
}

Box areaOf(const QSize& size) {
    return {{2.0, 1.0}, {size.width() / sweepPixelsPerMm - 1.0, size.height() / sweepPixelsPerMm - 0.5}};
}

}  // namespace

SweepView::SweepView(const Themes& themes, QWidget* parent) : QWidget(parent), themes_(themes) {
    setObjectName("sweepView");
    setAccessibleName(tr("Chart of the study"));
    setMouseTracking(true);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    connect(&themes, &Themes::changed, this, &SweepView::redraw);
}

void SweepView::show(SweepChart chart, const QString& message) {
    chart_ = std::move(chart);
    message_ = message;
    redraw();
}

void SweepView::setCase(long number) {
    if (number == case_) return;
    case_ = number;
    update();
}

bool SweepView::hasRoom() const { return width() >= leastChartWidth && height() >= leastChartHeight; }

void SweepView::redraw() {
    drawn_ = {};
    places_.clear();
    if (const auto* scatter = std::get_if<ScatterChart>(&chart_); scatter && !scatter->dots.empty() && hasRoom())
        for (const Point& place : dotPlaces(*scatter, areaOf(size())))
            places_.emplace_back(sweepPixelsPerMm * place.x(), sweepPixelsPerMm * place.y());
    update();
}

void SweepView::resizeEvent(QResizeEvent*) { redraw(); }

void SweepView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), themes_.current().panel);
    if (std::holds_alternative<std::monostate>(chart_) || !hasRoom()) {
        painter.setPen(themes_.current().text3);
        painter.drawText(rect().adjusted(16, 8, -16, -8), Qt::AlignCenter | Qt::TextWordWrap,
                         hasRoom() ? message_ : tr("Enlarge this page to see the chart."));
        return;
    }
    if (drawn_.isNull()) {
        drawn_ = QPixmap(size() * devicePixelRatioF());
        drawn_.setDevicePixelRatio(devicePixelRatioF());
        drawn_.fill(themes_.current().panel);
        QPainter sheet(&drawn_);
        sheet.setRenderHint(QPainter::Antialiasing);
        sheet.scale(sweepPixelsPerMm / unitsPerMm, sweepPixelsPerMm / unitsPerMm);
        Ink ink(sheet);
        const Box area = areaOf(size());
        const SweepTheme theme = sweepThemeOf(themes_.current());
        if (const auto* histogram = std::get_if<HistogramChart>(&chart_)) drawHistogram(ink, *histogram, area, theme);
        if (const auto* scatter = std::get_if<ScatterChart>(&chart_)) drawScatter(ink, *scatter, area, theme);
        if (const auto* tornado = std::get_if<TornadoChart>(&chart_)) drawTornado(ink, *tornado, area, theme);
        if (const auto* chances = std::get_if<ConvergenceChart>(&chart_)) drawConvergence(ink, *chances, area, theme);
    }
    painter.drawPixmap(0, 0, drawn_);
    if (const auto place = placeOf(case_)) {
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(QPen(themes_.current().text, 2.0));
        painter.drawEllipse(*place, 6, 6);
    }
}

std::optional<QPoint> SweepView::placeOf(long number) const {
    const auto* scatter = std::get_if<ScatterChart>(&chart_);
    if (!scatter || number < 1) return std::nullopt;
    for (std::size_t i = 0; i < places_.size(); ++i)
        if (scatter->dots[i].number == number) return places_[i].toPoint();
    return std::nullopt;
}

long SweepView::caseAt(const QPoint& place) const {
    const auto* scatter = std::get_if<ScatterChart>(&chart_);
    long nearest = 0;
    double least = clickReach;
    for (std::size_t i = 0; i < places_.size(); ++i) {
        const QPointF d = places_[i] - place;
        const double distance = std::hypot(d.x(), d.y());
        if (distance > least) continue;
        least = distance;
        nearest = scatter->dots[i].number;
    }
    return nearest;
}

void SweepView::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) return;
    if (const long number = caseAt(event->pos()); number > 0) Q_EMIT picked(number);
}

void SweepView::mouseDoubleClickEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) return;
    if (const long number = caseAt(event->pos()); number > 0) Q_EMIT activated(number);
}

void SweepView::mouseMoveEvent(QMouseEvent* event) {
    const long number = caseAt(event->pos());
    setCursor(number > 0 ? Qt::PointingHandCursor : Qt::ArrowCursor);
    if (number < 1) return QToolTip::hideText();
    for (const ScatterDot& dot : std::get<ScatterChart>(chart_).dots)
        if (dot.number == number)
            QToolTip::showText(event->globalPos(),
                               tr("Case %1: %2, %3. Double-click to open its scene.")
                                   .arg(number)
                                   .arg(Display::number(dot.x), Display::number(dot.y)),
                               this);
}

}  // namespace keyblock
