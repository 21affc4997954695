// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Pens for the curves of a chart: the colour, line and symbol of each style.
#pragma once

#include "ui/figure/chart_painter.h"

#include <QPen>
#include <QVector>

namespace keyblock {

inline constexpr double referenceLine = 0.25;  // line width of reference curves [mm]

/// Converts a length on paper [mm] to drawing units.
int unitsOf(double mm);
QColor inkOf(const Colour& colour, double opacity = 1.0);
Colour colourOf(const ChartTheme& theme, CurveStyle style);

/// A pen of the given width [mm]. \param dashes lengths of dashes and gaps, in units of the line width; empty: solid.
QPen chartPen(double width, const Colour& colour, const QVector<qreal>& dashes = {});
QPen penOf(const ChartTheme& theme, const ChartCurve& curve);

/// Dash pattern of a reference curve, in units of the line width; empty: solid.
std::vector<double> dashesOf(CurveStyle style);

/// Draws the symbol of a reference curve at a point [mm].
void drawMark(Ink& ink, const ChartTheme& theme, CurveStyle style, const Point& at);

}  // namespace keyblock
