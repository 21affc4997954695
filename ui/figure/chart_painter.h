// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Charts by QCustomPlot, which lays out axes and draws curves; the names at the ends of
// curves and limits are placed here so that they overlap nothing. Paper and screen draw
// the same charts in the colours of a theme.
#pragma once

#include "ui/figure/ink.h"
#include "ui/picture/chart.h"

#include <array>
#include <vector>

class QCPPainter;

namespace keyblock {

/// Colours of a chart. The caller paints the background.
struct ChartTheme {
    Colour ground, text, softText, axis, grid;
    Colour main, second, third, fourth, envelope;
    std::array<Colour, 4> references;
    Colour limit;  // ultimate limits
    Colour event;  // faint lines
    Colour zone;  // tint
};

/// Margins around the panels [mm].
struct ChartLayout {
    double leftRoom = 9.0, rightRoom = 17.0, panelGap = 3.2;
    bool titlesBeside = false;  // titles left of the panels, units below them; else above
    int mostTicks = mostPanelTicks;  // of a panel
};

/// White background, black ink.
const ChartTheme& paperChartTheme();

/// Position of the curves: the abscissas' range from left to right, and the panels from top to bottom [mm].
struct ChartPlace {
    struct Panel {
        double top = 0.0, bottom = 0.0;
    };
    double left = 0.0, right = 0.0, top = 0.0, bottom = 0.0;
    std::vector<Panel> panels{};
};

/// Draws the chart into the box [mm].
ChartPlace drawChart(QCPPainter& painter, const Chart& chart, const Box& box,
                     const ChartTheme& theme = paperChartTheme(), const ChartLayout& layout = {});

}  // namespace keyblock
