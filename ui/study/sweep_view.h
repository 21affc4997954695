// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A chart of a sweep in the window: distribution of a result, one column against another,
// influence of what varies, or convergence of the probability of failure. Dots are cases
// that can be clicked.
#pragma once

#include "ui/figure/sweep_figure.h"

#include <QPixmap>
#include <QWidget>

#include <optional>
#include <variant>
#include <vector>

namespace keyblock {

class Themes;

using SweepChart = std::variant<std::monostate, HistogramChart, ScatterChart, TornadoChart, ConvergenceChart>;

class SweepView : public QWidget {
    Q_OBJECT

public:
    explicit SweepView(const Themes& themes, QWidget* parent = nullptr);

    /// \param message shown while there is no chart
    void show(SweepChart chart, const QString& message);
    using QWidget::show;
    /// Marks a case; 0: none.
    void setCase(long number);

    /// Position of a case [px]; none if the chart has no dot of it.
    std::optional<QPoint> placeOf(long number) const;

Q_SIGNALS:
    void picked(long number);  // the user clicked on the dot of this case
    void activated(long number);  // double click

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    QSize minimumSizeHint() const override { return {240, 150}; }

private:
    bool hasRoom() const;
    void redraw();
    long caseAt(const QPoint& place) const;

    const Themes& themes_;
    SweepChart chart_;
    QString message_;
    long case_ = 0;
    QPixmap drawn_;
    std::vector<QPointF> places_;  // of the dots [px]
};

}  // namespace keyblock
