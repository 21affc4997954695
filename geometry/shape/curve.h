// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Converts the curves of drawings to polylines. All points lie on the curve, its ends
// are kept exactly, and the distance between an edge and the curve is at most the
// requested sagitta.
#pragma once

#include "geometry/point.h"

#include <string>
#include <vector>

namespace keyblock {

/// Points of the ellipse center + cos t·p + sin t·q for t from `start` to `start + sweep` [rad]; the sweep may be
/// negative. For a circle, p and q are perpendicular and of equal length. A full ellipse has 32 to 4096 edges.
/// \param sagitta [m] largest distance between an edge and the curve, > 0
std::vector<Point> ellipsePoints(const Point& center, const Point& p, const Point& q, double start, double sweep,
                                 double sagitta);

/// Points of a circular arc from a to b. The number of edges is limited as in `ellipsePoints`.
/// \param bulge tangent of a quarter of the angle subtended by the arc; positive: the arc lies to the right of a→b; 0:
/// straight line; 1: semicircle
/// \param sagitta [m] largest distance between an edge and the arc, > 0
std::vector<Point> bulgePoints(const Point& a, const Point& b, double bulge, double sagitta);

/// A rational B-spline.
struct Spline {
    int degree = 3;
    std::vector<double> knots;  // in non-decreasing order; control.size() + degree + 1 values
    std::vector<Point> control;  // control points [m]
    std::vector<double> weights;  // one per control point, all > 0; empty: all 1
};

/// Message about the first problem that makes the spline invalid; empty if it is valid.
std::string splineProblem(const Spline& spline);

/// Points of a spline. Every knot span is bisected, at most twelve times, until its middle and quarter points lie
/// within `sagitta` of the chord. \param sagitta [m] \pre splineProblem(spline) is empty.
std::vector<Point> splinePoints(const Spline& spline, double sagitta);

}  // namespace keyblock
