// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The charts of a sweep within an area of a sheet or of the window.
#pragma once

#include "ui/figure/ink.h"
#include "ui/figure/sweep_figure.h"

namespace keyblock {

/// Colours of these charts. The caller paints the ground.
struct SweepTheme {
    Colour ground, text, axis, grid;
    Colour bars, curve;  // of histograms and tornados
    Colour dots, marked;  // of cases; marked: of those that fail
    Colour band;  // of the interval of a probability
};

/// The theme for paper: white ground, black text.
const SweepTheme& paperSweepTheme();

// Each function draws a chart into an area [mm, y downwards]. \pre the chart has values, dots, bars or points
void drawHistogram(Ink& ink, const HistogramChart& chart, const Box& area, const SweepTheme& theme);
void drawScatter(Ink& ink, const ScatterChart& chart, const Box& area, const SweepTheme& theme);
void drawTornado(Ink& ink, const TornadoChart& chart, const Box& area, const SweepTheme& theme);
void drawConvergence(Ink& ink, const ConvergenceChart& chart, const Box& area, const SweepTheme& theme);

/// Position [mm] of each dot of a scatter chart drawn into this area. \pre the chart has dots
std::vector<Point> dotPlaces(const ScatterChart& chart, const Box& area);

/// Height of a tornado [mm], with its axis.
double tornadoHeight(const TornadoChart& chart);

}  // namespace keyblock
