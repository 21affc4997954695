// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A chart on the screen. Separate because QCustomPlot's header uses Qt's keywords,
// which the window disables.
#pragma once

#include "ui/figure/chart_painter.h"

class QPixmap;

namespace keyblock {

/// Draws the chart into the box [mm] of a pixmap with so many pixels per millimetre, in device-independent pixels.
ChartPlace drawChart(QPixmap& onto, double pixelsPerMm, const Chart& chart, const Box& box, const ChartTheme& theme,
                     const ChartLayout& layout);

}  // namespace keyblock
