// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/figure/application.h"
#include "ui/figure/chart_pixmap.h"

#include <gtest/gtest.h>

#include <QImage>
#include <QPixmap>

namespace keyblock {
namespace {

constexpr int pixelsPerMm = 8;

Chart chartWithNote(const std::string& note) {
    ChartPanel panel;
    panel.title = "Axial force (kN)";
    panel.note = note;
    panel.curves = {{"B", CurveStyle::Main, {0.0, 1.0}, {0.0, 10.0}}};
    panel.range = {0.0, 10.0};
    Chart chart;
    chart.xTitle = "time (s)";
    chart.x = {0.0, 1.0};
    chart.panels = {panel};
    return chart;
}

QImage drawn(const Chart& chart) {
    QPixmap pixmap(80 * pixelsPerMm, 40 * pixelsPerMm);
    pixmap.fill(Qt::white);
    drawChart(pixmap, pixelsPerMm, chart, {{0.0, 0.0}, {70.0, 40.0}}, paperChartTheme(), {});
    return pixmap.toImage();
}

/// Whether all pixels within a rectangle [mm] are white.
bool isBlank(const QImage& image, const QRectF& part) {
    for (int y = int(part.top() * pixelsPerMm); y < int(part.bottom() * pixelsPerMm); ++y)
        for (int x = int(part.left() * pixelsPerMm); x < int(part.right() * pixelsPerMm); ++x)
            if (image.pixelColor(x, y) != QColor(Qt::white)) return false;
    return true;
}

TEST(ChartPainter, ALongNoteStaysWithinTheChart) {
    needApplication();
    const QImage image = drawn(chartWithNote("tension positive; dashed: " + std::string(200, 'W')));
    EXPECT_FALSE(isBlank(image, {50.0, 0.0, 20.0, 3.0}));  // the note
    EXPECT_TRUE(isBlank(image, {70.0, 0.0, 10.0, 40.0}));
}

}  // namespace
}  // namespace keyblock
