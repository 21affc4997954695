// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The chart of a trade in the window: a dot for each run, which tells its settings and
// can be clicked.
#pragma once

#include "ui/figure/trade_figure.h"

#include <QWidget>

#include <optional>

namespace keyblock {

class Themes;
class TradePlot;

class TradeView : public QWidget {
    Q_OBJECT

public:
    explicit TradeView(const Themes& themes, QWidget* parent = nullptr);

    void show(TradeChart chart);
    using QWidget::show;
    /// The message is shown while there is no chart.
    void clear(const QString& message);

    /// Position of a dot [px], if the chart is shown. \pre the dot has a finite error.
    std::optional<QPoint> placeOf(std::size_t dot) const;

Q_SIGNALS:
    void picked(int dot);  // the user clicked on this dot

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    QSize minimumSizeHint() const override { return {220, 120}; }

private:
    bool hasPlot() const;
    TradePlot plot() const;
    int dotAt(const QPoint& place) const;
    QString textOf(const TradeDot& dot) const;

    const Themes& themes_;
    TradeChart chart_;
    QString message_;
};

}  // namespace keyblock
