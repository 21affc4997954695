// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Charts of a sweep: histogram with cumulative curve, scatter plot, tornado, and the
// convergence of a probability.
#pragma once

#include "ui/figure/figure.h"

#include <string>
#include <vector>

namespace keyblock {

struct HistogramChart {
    std::string title, subtitle, axis;
    std::vector<double> sorted;  // finite values in ascending order
};

struct ScatterDot {
    double x = 0.0, y = 0.0;
    bool isMarked = false;  // a case that fails
    long number = 0;  // of the case
};

struct ScatterChart {
    std::string title, subtitle, xAxis, yAxis;
    std::vector<ScatterDot> dots;
};

struct TornadoBar {
    std::string name;
    double value = 0.0;  // −1 … 1
};

struct TornadoChart {
    std::string title, subtitle;
    std::vector<TornadoBar> bars;  // from top to bottom; the first thirty are drawn
};

struct ChancePoint {
    double cases = 0.0, probability = 0.0, low = 0.0, high = 0.0;
};

struct ConvergenceChart {
    std::string title, subtitle;
    std::vector<ChancePoint> points;
};

// Each function draws a chart on a sheet of this width [mm] and returns the contents of the file.
// It throws CannotDraw if there is nothing to draw.
std::string paintHistogram(const HistogramChart& chart, PaperFormat format, double width = 120.0);
std::string paintScatter(const ScatterChart& chart, PaperFormat format, double width = 120.0);
std::string paintTornado(const TornadoChart& chart, PaperFormat format, double width = 120.0);
std::string paintConvergence(const ConvergenceChart& chart, PaperFormat format, double width = 120.0);

}  // namespace keyblock
