// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A chart on the screen. It stands apart because QCustomPlot's header takes the
// keywords of Qt, which the window does without.
#pragma once

#include "ui/figure/chart_ink.h"

class QPixmap;

namespace keyblock {

/// Draws the chart into the box [mm] of a pixmap with so many pixels per millimetre, counted as widgets do.
ChartPlace drawChart(QPixmap& onto, double pixelsPerMm, const Chart& chart, const Box& box, const ChartTheme& theme,
                     const ChartLayout& layout);

}  // namespace keyblock
