// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Pens of the curves of a chart: colour, line and mark by their style.
#pragma once

#include "ui/figure/chart_painter.h"

#include <QPen>
#include <QVector>

namespace keyblock {

inline constexpr double referenceLine = 0.25;  // [mm]

int unitsOf(double mm);
QColor inkOf(const Colour& colour, double opacity = 1.0);
Colour colourOf(const ChartTheme& theme, CurveStyle style);

/// `width` [mm]; `dashes` in line widths, empty: solid.
QPen chartPen(double width, const Colour& colour, const QVector<qreal>& dashes = {});
QPen penOf(const ChartTheme& theme, const ChartCurve& curve);

/// Dashes of a reference in line widths; empty: solid.
std::vector<double> dashesOf(CurveStyle style);

/// Each reference has its own mark. `at` [mm].
void drawMark(Ink& ink, const ChartTheme& theme, CurveStyle style, const Point& at);

}  // namespace keyblock
