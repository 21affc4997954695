// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Charts on paper by QCustomPlot, which lays out axes and draws curves; names at
// the ends of curves and limits are put there by us, where they cover nothing.
#pragma once

#include "ui/figure/ink.h"
#include "ui/picture/chart.h"

class QCPPainter;

namespace keyblock {

/// Where the curves are: the abscissas' range from left to right, and the panels from top to bottom [mm].
struct ChartPlace {
    double left = 0.0, right = 0.0, top = 0.0, bottom = 0.0;
};

/// Draws the chart into the box [mm].
ChartPlace drawChart(QCPPainter& painter, const Chart& chart, const Box& box);

}  // namespace keyblock
