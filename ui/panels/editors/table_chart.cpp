// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_KEYWORDS  // QCustomPlot's header has `signals:`
#include "ui/panels/editors/table_chart.h"

#include "ui/look/theme.h"

#include <QHBoxLayout>
#include <qcustomplot.h>

#include <algorithm>
#include <cmath>

namespace keyblock {

namespace {

constexpr int chartHeight = 132;

QFont tickFont() {
    QFont font("Inter");
    font.setPixelSize(10);
    return font;
}

/// Range of an axis around the curve. It starts at zero if that is near; other ends get a margin of 8 %.
QCPRange roomFor(double least, double most) {
    if (least > 0.0 && least < 0.5 * most) least = 0.0;
    if (most < 0.0 && most > 0.5 * least) most = 0.0;
    if (least == most)
        return {least - std::max(1.0, std::abs(least)) * 0.5, most + std::max(1.0, std::abs(most)) * 0.5};
    const double room = 0.08 * (most - least);
    return {least < 0.0 ? least - room : least, most > 0.0 ? most + room : most};
}

}  // namespace

TableChart::TableChart(const Themes& themes, QWidget* parent)
    : QWidget(parent), themes_(themes), plot_(new QCustomPlot(this)) {
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(plot_);
    setFixedHeight(chartHeight);
    plot_->setNoAntialiasingOnDrag(true);
    plot_->setAttribute(Qt::WA_TransparentForMouseEvents);  // lets the mouse wheel scroll the panel below
    plot_->addGraph();
    paintAxes();
    connect(&themes, &Themes::changed, this, [this] {
        paintAxes();
        plot_->replot(QCustomPlot::rpQueuedReplot);
    });
}

void TableChart::paintAxes() {
    const Theme& t = themes_.current();
    plot_->setBackground(QBrush(t.panel));
    for (QCPAxis* axis : {plot_->xAxis, plot_->yAxis}) {
        axis->setBasePen(QPen(t.border, 1));
        axis->setTickPen(Qt::NoPen);
        axis->setSubTickPen(Qt::NoPen);
        axis->setTickLabelFont(tickFont());
        axis->setTickLabelColor(t.text2);
        axis->setLabelFont(tickFont());
        axis->setLabelColor(t.text2);
        axis->setNumberPrecision(4);
        axis->ticker()->setTickCount(4);
        axis->grid()->setPen(QPen(t.chartGrid, 1));
        axis->grid()->setZeroLinePen(QPen(t.border, 1));
    }
    plot_->xAxis->grid()->setVisible(false);
    plot_->graph(0)->setPen(QPen(t.accent, 1.6));
    plot_->graph(0)->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssDisc, t.accent, 4));
}

void TableChart::present(const Table& shown, const QString& across, const QString& up) {
    QVector<double> x, y;
    for (const auto& [a, b] : shown)
        if (std::isfinite(a) && std::isfinite(b)) {
            x << a;
            y << b;
        }
    setVisible(x.size() > 1);
    if (x.size() < 2) return;
    plot_->graph(0)->setData(x, y);
    plot_->xAxis->setLabel(across);
    plot_->yAxis->setLabel(up);
    plot_->xAxis->setRange(roomFor(*std::min_element(x.begin(), x.end()), *std::max_element(x.begin(), x.end())));
    plot_->yAxis->setRange(roomFor(*std::min_element(y.begin(), y.end()), *std::max_element(y.begin(), y.end())));
    plot_->replot(QCustomPlot::rpQueuedReplot);
}

}  // namespace keyblock
