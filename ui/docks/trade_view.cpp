// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/trade_view.h"

#include "ui/docks/chart_view.h"
#include "ui/figure/paper.h"
#include "ui/figure/trade_plot.h"
#include "ui/look/display.h"
#include "ui/look/theme.h"

#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>

namespace keyblock {

namespace {

constexpr double pixelsPerMm = ChartView::pixelsPerMm;
constexpr double reach = 1.8;  // [mm] distance from a dot at which a click still finds it
constexpr int plotWidth = 180, plotHeight = 110;  // [px] smallest size of a readable chart

}  // namespace

TradeView::TradeView(const Themes& themes, QWidget* parent) : QWidget(parent), themes_(themes) {
    setObjectName("tradeView");
    setAccessibleName(tr("Accuracy and time"));
    setMouseTracking(true);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    connect(&themes, &Themes::changed, this, [this] { update(); });
}

void TradeView::show(TradeChart chart) {
    chart_ = std::move(chart);
    update();
}

void TradeView::clear(const QString& message) {
    chart_ = {};
    message_ = message;
    update();
}

bool TradeView::hasPlot() const { return TradePlot::canShow(chart_) && width() >= plotWidth && height() >= plotHeight; }

TradePlot TradeView::plot() const {
    const Box area{{1.5, 0.0}, {width() / pixelsPerMm, height() / pixelsPerMm}};
    return {chart_, area, chartThemeOf(themes_.current())};
}

std::optional<QPoint> TradeView::placeOf(std::size_t dot) const {
    if (!hasPlot()) return std::nullopt;
    const Point place = pixelsPerMm * plot().placeOf(chart_.dots[dot]);
    return QPointF(place.x(), place.y()).toPoint();
}

int TradeView::dotAt(const QPoint& place) const {
    return hasPlot() ? plot().dotAt({place.x() / pixelsPerMm, place.y() / pixelsPerMm}, reach) : -1;
}

QString TradeView::textOf(const TradeDot& dot) const {
    return tr("%1: %2 s, largest error %3 %. Click to use these settings.")
        .arg(QString::fromStdString(dot.name), Display::number(dot.seconds, 3), Display::number(100.0 * dot.error, 3));
}

void TradeView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), themes_.current().panel);
    if (!hasPlot()) {
        painter.setPen(themes_.current().text3);
        painter.drawText(rect().adjusted(12, 8, -12, -8), Qt::AlignCenter | Qt::TextWordWrap,
                         TradePlot::canShow(chart_) ? tr("Enlarge this panel to see the chart.") : message_);
        return;
    }
    painter.setRenderHint(QPainter::Antialiasing);
    painter.scale(pixelsPerMm / unitsPerMm, pixelsPerMm / unitsPerMm);
    Ink ink(painter);
    plot().draw(ink);
}

void TradeView::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) return;
    if (const int dot = dotAt(event->pos()); dot >= 0) Q_EMIT picked(dot);
}

void TradeView::mouseMoveEvent(QMouseEvent* event) {
    const int dot = dotAt(event->pos());
    setCursor(dot >= 0 ? Qt::PointingHandCursor : Qt::ArrowCursor);
    if (dot >= 0) QToolTip::showText(event->globalPos(), textOf(chart_.dots[static_cast<std::size_t>(dot)]), this);
    else QToolTip::hideText();
}

}  // namespace keyblock
