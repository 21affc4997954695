// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/verify/reference/softening_bar.h"

#include <cmath>

namespace keyblock::reference {
namespace {

constexpr int steps = 20000;
constexpr int halvings = 80;

struct Point {
    double slip = 0.0, force = 0.0;
};

double bondAt(const SofteningBond& bond, double slip) {
    const double atPeak = bond.peak / bond.stiffness;
    if (slip <= atPeak) return bond.stiffness * slip;
    if (slip >= atPeak + bond.slip) return bond.residual;
    return bond.peak - (bond.peak - bond.residual) * (slip - atPeak) / bond.slip;
}

double strainAt(const EmbeddedBar& bar, double force) {
    const double stress = force / bar.area;
    std::pair<double, double> from{0.0, 0.0}, to = bar.steel.front();
    for (std::size_t i = 1; i < bar.steel.size() && stress > to.second; ++i) from = to, to = bar.steel[i];
    return from.first + (to.first - from.first) * (stress - from.second) / (to.second - from.second);
}

/// From the free end, which has moved by `slip`, to the joint (Runge and Kutta's fourth order).
Point atJoint(const EmbeddedBar& bar, double slip) {
    const double h = bar.length / steps;
    const auto rate = [&](double x, const Point& p) {
        const bool outside = x + p.slip > bar.length;  // drawn out of the rock
        return Point{strainAt(bar, p.force), outside ? 0.0 : bondAt(bar.bond, p.slip)};
    };
    const auto ahead = [](const Point& p, const Point& r, double way) {
        return Point{p.slip + way * r.slip, p.force + way * r.force};
    };
    Point p{slip, 0.0};
    for (int i = 0; i < steps; ++i) {
        const double x = i * h, middle = x + 0.5 * h;
        const Point a = rate(x, p), b = rate(middle, ahead(p, a, 0.5 * h)), c = rate(middle, ahead(p, b, 0.5 * h)),
                    d = rate(x + h, ahead(p, c, h));
        p.slip += h / 6.0 * (a.slip + 2.0 * b.slip + 2.0 * c.slip + d.slip);
        p.force += h / 6.0 * (a.force + 2.0 * b.force + 2.0 * c.force + d.force);
    }
    return p;
}

/// Where `valueOf` of the joint is `wanted`, by halving the logarithm of the slip at the free end.
template <typename Value>
Point found(const EmbeddedBar& bar, double most, double wanted, const Value& valueOf) {
    double low = std::log(1e-30), high = std::log(most);
    for (int i = 0; i < halvings; ++i) {
        const double middle = 0.5 * (low + high);
        (valueOf(atJoint(bar, std::exp(middle))) < wanted ? low : high) = middle;
    }
    return atJoint(bar, std::exp(low));
}

}  // namespace

double forceAtSlip(const EmbeddedBar& bar, double slip) {
    return found(bar, slip, slip, [](const Point& p) { return p.slip; }).force;
}

double slipAtForce(const EmbeddedBar& bar, double force) {
    return found(bar, 1e-3, force, [](const Point& p) { return p.force; }).slip;
}

}  // namespace keyblock::reference
