// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// An arc of half-angle h has the sagitta r(1 − cos h) = 2r sin²(h/2), so edges that turn by 4·asin √(s / 2r) have the
// sagitta s. An ellipse is a circle stretched at most to its larger half-axis, which takes the place of r.
//
// An arc is given by its bulge b = tan(φ/2), where φ is half of its angle, and is drawn in the frame of its chord. Its
// offset from the chord is R(cos θ − cos φ) = 2R sin((φ+θ)/2) sin((φ−θ)/2), which stays accurate even if the centre is
// far away.
#include "geometry/shape/curve.h"

#include "geometry/segment.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace keyblock {

namespace {

constexpr double leastEdges = 32.0, mostEdges = 4096.0;  // number of edges of a full circle

int edgesOf(double radius, double sweep, double sagitta) {
    const double turn = 2.0 * std::numbers::pi;
    const double share = std::min(1.0, sagitta / (2.0 * radius));
    const double step = 4.0 * std::asin(std::sqrt(share));
    const double perTurn = std::clamp(step > 0.0 ? turn / step : mostEdges, leastEdges, mostEdges);
    return std::max(1, static_cast<int>(std::ceil(perTurn * std::abs(sweep) / turn - 1e-9)));
}

/// de Boor's algorithm on homogeneous points (x·w, y·w, w) in the knot interval [i, i + 1), where i is `span`.
Point splinePoint(const Spline& spline, std::size_t span, double t) {
    const std::size_t degree = spline.degree;
    std::vector<Eigen::Vector3d> d;
    for (std::size_t j = span - degree; j <= span; ++j) {
        const double w = spline.weights.empty() ? 1.0 : spline.weights[j];
        d.emplace_back(spline.control[j].x() * w, spline.control[j].y() * w, w);
    }
    for (std::size_t r = 1; r <= degree; ++r)
        for (std::size_t j = degree; j >= r; --j) {
            const double low = spline.knots[span - degree + j], high = spline.knots[span + 1 + j - r];
            const double share = (t - low) / (high - low);
            d[j] = (1.0 - share) * d[j - 1] + share * d[j];
        }
    return {d[degree].x() / d[degree].z(), d[degree].y() / d[degree].z()};
}

class SplineDrawing {
public:
    SplineDrawing(const Spline& spline, double sagitta) : spline_(spline), sagitta_(sagitta) {}

    std::vector<Point> points() {
        const std::size_t degree = spline_.degree;
        for (std::size_t span = degree; span < spline_.control.size(); ++span) {
            const double from = spline_.knots[span], to = spline_.knots[span + 1];
            if (!(to > from)) continue;
            const Point first = splinePoint(spline_, span, from), last = splinePoint(spline_, span, to);
            if (points_.empty()) points_.push_back(first);
            refine(span, from, first, to, last, 0);
        }
        return points_;
    }

private:
    /// Adds the points after `a` up to and including `b`.
    void refine(std::size_t span, double from, const Point& a, double to, const Point& b, int depth) {
        constexpr int least = 2, most = 12;
        const double middle = 0.5 * (from + to);
        const Point m = splinePoint(spline_, span, middle);
        const auto off = [&](const Point& p) { return distanceToSegment(a, b, p); };
        const bool near = off(m) <= sagitta_ && off(splinePoint(spline_, span, 0.5 * (from + middle))) <= sagitta_ &&
                          off(splinePoint(spline_, span, 0.5 * (middle + to))) <= sagitta_;
        const bool straight = spline_.degree == 1;
        if (straight || depth >= most || (near && depth >= least)) {
            points_.push_back(b);
            return;
        }
        refine(span, from, a, middle, m, depth + 1);
        refine(span, middle, m, to, b, depth + 1);
    }

    const Spline& spline_;
    double sagitta_;
    std::vector<Point> points_;
};

}  // namespace

std::vector<Point> ellipsePoints(const Point& center, const Point& p, const Point& q, double start, double sweep,
                                 double sagitta) {
    const int edges = edgesOf(std::max(p.norm(), q.norm()), sweep, sagitta);
    std::vector<Point> points;
    for (int i = 0; i <= edges; ++i) {
        const double t = start + sweep * i / edges;
        points.push_back(center + std::cos(t) * p + std::sin(t) * q);
    }
    return points;
}

std::vector<Point> bulgePoints(const Point& a, const Point& b, double bulge, double sagitta) {
    const Point chord = b - a;
    const double length = chord.norm();
    if (bulge == 0.0 || length == 0.0) return {a, b};
    const double half = 2.0 * std::atan(bulge);  // φ, with the sign of the bulge
    const double radius = 0.5 * length / std::sin(half);
    const Point along = chord / length, left(-along.y(), along.x()), middle = a + 0.5 * chord;
    const int edges = edgesOf(std::abs(radius), 2.0 * half, sagitta);
    std::vector<Point> points{a};
    for (int i = 1; i < edges; ++i) {
        const double theta = half * (2.0 * i / edges - 1.0);
        const double across = 2.0 * radius * std::sin(0.5 * (half + theta)) * std::sin(0.5 * (half - theta));
        points.push_back(middle + radius * std::sin(theta) * along - across * left);
    }
    points.push_back(b);
    return points;
}

std::string splineProblem(const Spline& spline) {
    const std::size_t control = spline.control.size();
    if (spline.degree < 1 || spline.degree > 25) return "its degree is " + std::to_string(spline.degree);
    const std::size_t degree = spline.degree;
    if (control < degree + 1)
        return "it has " + std::to_string(control) + " of the " + std::to_string(degree + 1) +
               " control points that degree " + std::to_string(degree) + " needs";
    if (spline.knots.size() != control + degree + 1)
        return "it has " + std::to_string(spline.knots.size()) + " knots instead of " +
               std::to_string(control + degree + 1);
    if (!std::is_sorted(spline.knots.begin(), spline.knots.end())) return "its knots decrease";
    if (!(spline.knots[control] > spline.knots[degree])) return "all its knots are equal";
    for (std::size_t i = degree; i + degree + 1 < spline.knots.size(); ++i)
        if (spline.knots[i] == spline.knots[i + degree + 1])
            return "a knot is repeated more than " + std::to_string(degree + 1) + " times";
    if (!spline.weights.empty() && spline.weights.size() != control) return "the number of its weights differs from "
                                                                            "the number of its points";
    if (std::any_of(spline.weights.begin(), spline.weights.end(), [](double w) { return !(w > 0.0); }))
        return "a weight is not above 0";
    return {};
}

std::vector<Point> splinePoints(const Spline& spline, double sagitta) {
    return SplineDrawing(spline, sagitta).points();
}

}  // namespace keyblock
