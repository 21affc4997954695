// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/figure/chart_pens.h"

#include "ui/figure/paper.h"

#include <cmath>

namespace keyblock {

using namespace paper_theme;

int unitsOf(double mm) { return static_cast<int>(std::lround(mm * unitsPerMm)); }

QColor inkOf(const Colour& colour, double opacity) {
    QColor result(colour.red, colour.green, colour.blue);
    result.setAlphaF(opacity);
    return result;
}

QPen chartPen(double width, const Colour& colour, const QVector<qreal>& dashes) {
    QPen result(inkOf(colour), width * unitsPerMm);
    if (!dashes.empty()) result.setDashPattern(dashes);
    result.setCapStyle(dashes.empty() ? Qt::RoundCap : Qt::FlatCap);
    result.setJoinStyle(Qt::RoundJoin);
    return result;
}

Colour colourOf(const ChartTheme& theme, CurveStyle style) {
    switch (style) {
        case CurveStyle::Main:
        case CurveStyle::Stems: return theme.main;
        case CurveStyle::Second: return theme.second;
        case CurveStyle::Third: return theme.third;
        case CurveStyle::Fourth: return theme.fourth;
        case CurveStyle::Reference: return theme.references[0];
        case CurveStyle::SecondReference: return theme.references[1];
        case CurveStyle::ThirdReference: return theme.references[2];
        case CurveStyle::FourthReference: return theme.references[3];
        case CurveStyle::Envelope: break;
    }
    return theme.envelope;
}

std::vector<double> dashesOf(CurveStyle style) {
    switch (style) {
        case CurveStyle::Reference: return {5.0, 3.0};
        case CurveStyle::SecondReference: return {9.0, 3.0};
        case CurveStyle::ThirdReference: return {2.0, 2.5};
        case CurveStyle::FourthReference: return {9.0, 3.0, 2.0, 3.0};
        default: return {};
    }
}

void drawMark(Ink& ink, const ChartTheme& theme, CurveStyle style, const Point& at) {
    const double r = 0.65;
    const Stroke line{0.17, colourOf(theme, style)};
    const auto outline = [&](std::vector<Point> points) {
        for (Point& point : points) point = at + r * point;
        ink.polygon(points, theme.ground, line);
    };
    switch (style) {
        case CurveStyle::SecondReference: return outline({{-0.9, -0.9}, {0.9, -0.9}, {0.9, 0.9}, {-0.9, 0.9}});
        case CurveStyle::ThirdReference: return outline({{0.0, -1.1}, {1.0, 0.8}, {-1.0, 0.8}});
        case CurveStyle::FourthReference: return outline({{0.0, -1.2}, {1.2, 0.0}, {0.0, 1.2}, {-1.2, 0.0}});
        default: ink.circle(at, r, theme.ground, line);
    }
}

QPen penOf(const ChartTheme& theme, const ChartCurve& curve) {
    const Colour colour = colourOf(theme, curve.style);
    if (isReference(curve.style)) {
        const std::vector<double> dashes = dashesOf(curve.style);
        return chartPen(referenceLine, colour, QVector<qreal>(dashes.begin(), dashes.end()));
    }
    if (curve.ofOther) return chartPen(0.25, colour, {3.0, 2.0});
    switch (curve.style) {
        case CurveStyle::Envelope: return chartPen(0.17, colour, {5.0, 3.0});
        case CurveStyle::Third: return chartPen(0.3, colour, {6.0, 2.5});
        case CurveStyle::Fourth: return chartPen(0.3, colour, {1.5, 2.5});
        default: return chartPen(0.3, colour);
    }
}

const ChartTheme& paperChartTheme() {
    static const ChartTheme theme{white, black, softText, paper_theme::axis, paper_theme::grid,
                                  paper_theme::ribbon, rgb(0xB63100), rgb(0x1B7F55), rgb(0x4A5260), rgb(0x8A93A0),
                                  {rgb(0x111111), rgb(0x8A5A00), rgb(0x7A2E7A), rgb(0x2B6E8F)},
                                  error, rgb(0xC9A3A6), slipping};
    return theme;
}

}  // namespace keyblock
