// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A chart in a dock, drawn as in a printed figure but in the colours of the window,
// with the current time marked.
#pragma once

#include "ui/figure/chart_painter.h"

#include <QPixmap>
#include <QString>
#include <QWidget>

#include <optional>

namespace keyblock {

class Themes;
struct Theme;

ChartTheme chartThemeOf(const Theme& theme);

/// Where the current time is marked on a chart: at `x` on the horizontal axis, and by a point on the first curve of
/// each panel. A panel without a value at this time has no point.
struct ChartNow {
    double x = 0.0;
    std::vector<std::optional<double>> y;  // one per panel
};

class ChartView : public QWidget {
    Q_OBJECT

public:
    explicit ChartView(const Themes& themes, QWidget* parent = nullptr);

    void show(Chart chart);
    using QWidget::show;
    /// Removes the chart and shows the message instead.
    void clear(const QString& message);
    void setNow(std::optional<ChartNow> now);
    void setRoom(const ChartLayout& layout);
    const std::optional<Chart>& chart() const { return chart_; }

    /// Redraws the chart if it has changed. Call this before using the pixel positions of the chart to paint next to
    /// it.
    void prepare();
    /// True if the chart has enough room and has been drawn, so that its pixel positions are known.
    bool isDrawn() const { return chart_ && !drawn_.isNull(); }
    /// Position [px] of a value on the horizontal axis, and of a value on the vertical axis of a panel.
    /// \pre `isDrawn()`
    double xOf(double value) const;
    double yOf(std::size_t panel, double value) const;

    static constexpr double pixelsPerMm = 5.25;  // so that letters 2 mm high in figures have 10.5 px here

Q_SIGNALS:
    void picked(double x);  // the user clicked at this value on the horizontal axis
    void redrawn();  // pixel positions have changed

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    QSize minimumSizeHint() const override { return {200, 100}; }

private:
    bool hasRoom() const;
    void redraw();
    void paintMessage(QPainter& painter) const;
    void paintNow(QPainter& painter) const;
    QString valuesAt(double x) const;
    QString table() const;

    const Themes& themes_;
    std::optional<Chart> chart_;
    ChartLayout layout_;
    QString message_;
    std::optional<ChartNow> now_;
    QPixmap drawn_;
    ChartPlace place_;
};

}  // namespace keyblock
