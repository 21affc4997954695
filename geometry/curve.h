// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Curves of drawings as lines of points. Points lie on the curve, its ends are
// kept as they were given, and no edge lies farther from the curve than the
// requested sagitta.
#pragma once

#include "geometry/point.h"

#include <string>
#include <vector>

namespace keyblock {

/// Points of an ellipse c + cos t·p + sin t·q for t from `start` over `sweep` [rad], in either direction. Of a circle,
/// p and q are normal to each other and as long. At least 32 edges to a full turn, at most 4096; `sagitta` > 0 [m].
std::vector<Point> ellipsePoints(const Point& center, const Point& p, const Point& q, double start, double sweep,
                                 double sagitta);

/// Points of the arc from a to b whose bulge is the tangent of a quarter of its angle: positive with the arc to the
/// right of a→b, 0 straight, 1 a half circle. Edges as above.
std::vector<Point> bulgePoints(const Point& a, const Point& b, double bulge, double sagitta);

/// A rational B-spline.
struct Spline {
    int degree = 3;
    std::vector<double> knots;  // not falling; control.size() + degree + 1
    std::vector<Point> control;  // [m]
    std::vector<double> weights;  // as many as control points, all > 0; empty: 1
};

/// What keeps a spline from being drawn, for people; empty when nothing does.
std::string splineProblem(const Spline& spline);

/// Points of a spline: every span between knots is halved until its middle and quarters lie within `sagitta` [m] of the
/// chord, twelve times at most. \pre splineProblem(spline) is empty.
std::vector<Point> splinePoints(const Spline& spline, double sagitta);

}  // namespace keyblock
