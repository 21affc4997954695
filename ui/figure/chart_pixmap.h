// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Draws a chart on the screen. This header is separate because that of QCustomPlot uses
// Qt's keywords, which the window disables.
#pragma once

#include "ui/figure/chart_painter.h"

class QPixmap;

namespace keyblock {

/// Draws the chart into the box [mm] of a pixmap. \param pixelsPerMm device-independent pixels per millimetre.
ChartPlace drawChart(QPixmap& onto, double pixelsPerMm, const Chart& chart, const Box& box, const ChartTheme& theme,
                     const ChartLayout& layout);

}  // namespace keyblock
