// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Draws charts with QCustomPlot, which lays out the axes and draws the curves. The
// names at the ends of curves and limits are placed here, so that they do not overlap.
// Paper and screen show the same charts in the colours of a theme.
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
    Colour limit;  // of ultimate limits
    Colour event;  // of the faint lines at events
    Colour zone;  // of shaded intervals
};

/// Space around the panels [mm] and position of their titles.
struct ChartLayout {
    double leftRoom = 9.0, rightRoom = 17.0, panelGap = 3.2;
    bool titlesBeside = false;  // titles to the left of the panels with units below them; false: above the panels
    int mostTicks = mostPanelTicks;  // maximum number of ticks on the vertical axis of a panel
};

/// The theme for paper: white background, black text.
const ChartTheme& paperChartTheme();

/// Area in which the curves are drawn [mm, y downwards], and the vertical extent of each panel, in order from top to
/// bottom.
struct ChartPlace {
    struct Panel {
        double top = 0.0, bottom = 0.0;
    };
    double left = 0.0, right = 0.0, top = 0.0, bottom = 0.0;
    std::vector<Panel> panels{};
};

/// Draws the chart into the box [mm] and returns the area of the curves.
ChartPlace drawChart(QCPPainter& painter, const Chart& chart, const Box& box,
                     const ChartTheme& theme = paperChartTheme(), const ChartLayout& layout = {});

}  // namespace keyblock
