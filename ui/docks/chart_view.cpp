// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/chart_view.h"

#include "ui/canvas/view_theme.h"
#include "ui/figure/chart_pixmap.h"
#include "ui/look/display.h"
#include "ui/look/plain_text.h"
#include "ui/look/theme.h"

#include <QApplication>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QMenu>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace keyblock {

namespace {

constexpr int leastWidth = 140, leastHeight = 62;  // [px] smallest size of a readable chart
constexpr double leastPanel = 38.0;  // [px] height; panels that would get less are omitted, the last first
constexpr double pixelsPerTick = 17.0;
constexpr double axisRoom = 24.0;  // [px] height of the labels of the x axis

Colour mixed(const QColor& a, const QColor& b, double share) {
    const auto mix = [&](int from, int to) { return static_cast<std::uint8_t>(std::lround(from + share * (to - from))); };
    return {mix(a.red(), b.red()), mix(a.green(), b.green()), mix(a.blue(), b.blue())};
}

/// The chart with as many of its first panels as fit into the height.
Chart fittingChart(const Chart& chart, int height) {
    Chart fitting = chart;
    const auto most = static_cast<std::size_t>(std::max(1.0, (height - axisRoom) / leastPanel));
    if (fitting.panels.size() > most) fitting.panels.resize(most);
    return fitting;
}

}  // namespace

ChartTheme chartThemeOf(const Theme& theme) {
    ChartTheme chart;
    chart.ground = colourOf(theme.panel);
    chart.text = colourOf(theme.text);
    chart.softText = colourOf(theme.text2);
    chart.axis = colourOf(theme.border);
    chart.grid = colourOf(theme.chartGrid);
    chart.main = colourOf(theme.accent);
    chart.second = colourOf(theme.text2);
    chart.third = colourOf(theme.ok);
    chart.fourth = colourOf(theme.warning);
    chart.envelope = colourOf(theme.text3);
    chart.references = {colourOf(theme.text), colourOf(theme.warning), colourOf(theme.yielded), colourOf(theme.ok)};
    chart.limit = colourOf(theme.error);
    chart.event = mixed(theme.panel, theme.slipping, 0.35);
    chart.zone = colourOf(theme.slipping);
    return chart;
}

ChartView::ChartView(const Themes& themes, QWidget* parent) : QWidget(parent), themes_(themes) {
    setObjectName("chart");
    setAccessibleName(tr("Chart"));
    setMouseTracking(true);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    connect(&themes, &Themes::changed, this, [this] {
        drawn_ = {};
        update();
    });
}

void ChartView::show(Chart chart) {
    chart_ = std::move(chart);
    drawn_ = {};
    update();
}

void ChartView::clear(const QString& message) {
    if (!chart_ && message == message_) return;
    chart_.reset();
    now_.reset();
    message_ = message;
    drawn_ = {};
    update();
}

void ChartView::setNow(std::optional<ChartNow> now) {
    now_ = std::move(now);
    update();
}

void ChartView::setRoom(const ChartLayout& layout) {
    layout_ = layout;
    drawn_ = {};
    update();
}

double ChartView::xOf(double value) const {
    assert(isDrawn());
    const ValueRange& range = chart_->x;
    return pixelsPerMm * (place_.left + (place_.right - place_.left) * (value - range.low) / (range.high - range.low));
}

double ChartView::yOf(std::size_t panel, double value) const {
    assert(isDrawn());
    const ValueRange& range = chart_->panels[panel].range;
    const ChartPlace::Panel& place = place_.panels[panel];
    return pixelsPerMm *
           (place.bottom - (place.bottom - place.top) * (value - range.low) / (range.high - range.low));
}

bool ChartView::hasRoom() const { return width() >= leastWidth && height() >= leastHeight; }

void ChartView::prepare() {
    if (chart_ && !chart_->panels.empty() && drawn_.isNull() && hasRoom()) redraw();
}

void ChartView::redraw() {
    const double ratio = devicePixelRatioF();
    drawn_ = QPixmap(size() * ratio);
    drawn_.setDevicePixelRatio(ratio);
    drawn_.fill(themes_.current().panel);
    ChartLayout layout = layout_;
    Chart chart = fittingChart(*chart_, height());
    const double perPanel = (height() - axisRoom) / static_cast<double>(chart.panels.size());
    layout.mostTicks = std::clamp(static_cast<int>(perPanel / pixelsPerTick), 2, mostPanelTicks);
    for (ChartPanel& panel : chart.panels)  // no more points than the pixels can resolve
        for (ChartCurve& curve : panel.curves)
            curve = thinned(curve, static_cast<std::size_t>(std::max(400, 3 * width())));
    const Box box{{0.6, 0.8}, {width() / pixelsPerMm - 0.6, height() / pixelsPerMm - 0.6}};
    place_ = drawChart(drawn_, pixelsPerMm, chart, box, chartThemeOf(themes_.current()), layout);
    Q_EMIT redrawn();
}

void ChartView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    if (!chart_ || chart_->panels.empty() || !hasRoom()) return paintMessage(painter);
    prepare();
    painter.drawPixmap(0, 0, drawn_);
    if (now_) paintNow(painter);
}

/// Paints a text that says why there is no chart or that there is no room for it.
void ChartView::paintMessage(QPainter& painter) const {
    const bool isShort = chart_ && !chart_->panels.empty();
    painter.fillRect(rect(), themes_.current().panel);
    painter.setPen(themes_.current().text3);
    const int rim = height() < leastHeight ? 0 : 8;
    painter.drawText(rect().adjusted(16, rim, -16, -rim), Qt::AlignCenter | Qt::TextWordWrap,
                     isShort ? tr("Enlarge this panel to see the chart.") : message_);
}

/// Paints a dot on the curve with its value and hairlines to the axes. If the x axis is time, it paints a line through
/// all panels.
void ChartView::paintNow(QPainter& painter) const {
    const Theme& theme = themes_.current();
    if (place_.panels.empty()) return;
    const double x = xOf(std::clamp(now_->x, chart_->x.low, chart_->x.high));  // a run may be ahead of its chart
    QPen hair(theme.accent, 1.0);
    hair.setDashPattern({2.0, 2.0});
    painter.setPen(hair);
    painter.drawLine(QPointF(x, pixelsPerMm * place_.top), QPointF(x, pixelsPerMm * place_.bottom));
    QFont font = painter.font();
    font.setPixelSize(11);
    font.setWeight(QFont::DemiBold);
    painter.setFont(font);
    const QFontMetricsF metrics(font);
    for (std::size_t p = 0; p < now_->y.size() && p < place_.panels.size(); ++p) {
        if (!now_->y[p]) continue;
        const double y = yOf(p, *now_->y[p]);
        if (y < pixelsPerMm * place_.panels[p].top - 4.0 || y > pixelsPerMm * place_.panels[p].bottom + 4.0) continue;
        painter.setPen(hair);
        if (!chart_->overTime) painter.drawLine(QPointF(pixelsPerMm * place_.left, y), QPointF(x, y));
        painter.setPen(QPen(theme.panel, 1.5));
        painter.setBrush(theme.accent);
        painter.drawEllipse(QPointF(x, y), 4.0, 4.0);
        const QString value = Display::number(*now_->y[p], 4);
        const double wide = metrics.horizontalAdvance(value);
        const bool left = x + 8.0 + wide > pixelsPerMm * place_.right;  // names of curves are further to the right
        const QRectF box(left ? x - 8.0 - wide : x + 8.0, std::max(y - 16.0, pixelsPerMm * place_.panels[p].top), wide,
                         14.0);  // below the title
        QColor ground = theme.panel;
        ground.setAlphaF(0.8);
        painter.fillRect(box.adjusted(-2.0, 0.0, 2.0, 0.0), ground);
        painter.setPen(theme.accent);
        painter.drawText(box, Qt::AlignCenter, value);
    }
}

void ChartView::resizeEvent(QResizeEvent*) { drawn_ = {}; }

void ChartView::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || !chart_ || drawn_.isNull() || place_.right <= place_.left) return;
    const double share = (event->localPos().x() / pixelsPerMm - place_.left) / (place_.right - place_.left);
    if (share >= -0.02 && share <= 1.02)
        Q_EMIT picked(chart_->x.low + std::clamp(share, 0.0, 1.0) * (chart_->x.high - chart_->x.low));
}

void ChartView::mouseMoveEvent(QMouseEvent* event) {
    if (event->buttons() & Qt::LeftButton) return mousePressEvent(event);
    if (!chart_ || drawn_.isNull() || place_.right <= place_.left) return;
    const double share = (event->localPos().x() / pixelsPerMm - place_.left) / (place_.right - place_.left);
    if (share < 0.0 || share > 1.0) return QToolTip::hideText();
    QToolTip::showText(event->globalPos(), asTip(valuesAt(chart_->x.low + share * (chart_->x.high - chart_->x.low))),
                       this);
}

/// The value of each curve at the abscissa, from its nearest point.
QString ChartView::valuesAt(double x) const {
    QString text;
    if (!chart_->isStaged()) {
        text = QString::fromStdString(chart_->xTitle) + QStringLiteral(": ") + Display::number(x, 4);
    } else {
        const StageMoment moment = momentAt(chart_->stages, x);
        text = QString::fromStdString(moment.span->name) + QStringLiteral(": ") + Display::number(moment.time, 4);
    }
    for (const ChartPanel& panel : chart_->panels)
        for (const ChartCurve& curve : panel.curves) {
            if (curve.x.empty() || (curve.name.empty() && panel.curves.size() > 1)) continue;
            std::size_t nearest = 0;
            for (std::size_t i = 1; i < curve.x.size(); ++i)
                if (std::abs(curve.x[i] - x) < std::abs(curve.x[nearest] - x)) nearest = i;
            text += QStringLiteral("\n") + QString::fromStdString(curve.name.empty() ? panel.title : curve.name) +
                    QStringLiteral(": ") + Display::number(curve.y[nearest], 4);
        }
    return text;
}

void ChartView::contextMenuEvent(QContextMenuEvent* event) {
    if (!chart_ || drawn_.isNull()) return;
    QMenu menu(this);
    menu.addAction(tr("Copy image"), this, [this] { QApplication::clipboard()->setPixmap(drawn_); });
    menu.addAction(tr("Copy values"), this, [this] { QApplication::clipboard()->setText(table()); });
    menu.exec(event->globalPos());
}

/// The chart as text for spreadsheets: one block of columns per curve, one below the other.
QString ChartView::table() const {
    QString text;
    for (const ChartPanel& panel : chart_->panels)
        for (const ChartCurve& curve : panel.curves) {
            const std::string name = panel.title + (curve.name.empty() ? "" : " " + curve.name);
            const bool staged = chart_->isStaged();
            if (staged) text += tr("stage") + '\t';
            text += QString::fromStdString(chart_->xTitle) + '\t' + QString::fromStdString(name) + '\n';
            for (std::size_t i = 0; i < curve.x.size(); ++i) {
                double x = curve.x[i];
                if (staged) {
                    const StageMoment moment = momentAt(chart_->stages, x);
                    text += QString::fromStdString(moment.span->name) + '\t';
                    x = moment.time;
                }
                text += QString::number(x, 'g', 12) + '\t' + QString::number(curve.y[i], 'g', 12) + '\n';
            }
        }
    return text;
}

}  // namespace keyblock
