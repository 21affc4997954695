// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A block on a slope under a sine wave and a record, as body acceleration and
// as base acceleration. The motion of a rigid block with friction is integrated
// for comparison.
#include "solver/verify/checks.h"
#include "solver/verify/groups.h"
#include "solver/verify/readings.h"
#include "solver/verify/scenes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace keyblock {

namespace {

constexpr double planeSlope = 20.0, friction = 22.0;  // [°]
constexpr double amplitude = 0.1 * gravity, frequency = 1.0, duration = 5.0;

Sine shaking() { return {amplitude, frequency, 0.0}; }

Table recordOfTheSine() {
    Table record;
    const int rows = 500;
    for (int i = 0; i <= rows; ++i) {
        const double t = duration * i / rows;
        record.emplace_back(t, std::sin(2.0 * std::numbers::pi * frequency * t));
    }
    return record;
}

/// \param towards 1: positive values act down the dip; −1: up the dip
Acceleration sineAcceleration(double towards) {
    Acceleration a;
    a.sine = shaking();
    a.axis = {towards, 0.0};
    return a;
}

Acceleration recordAcceleration(double towards) {
    Acceleration a;
    a.record = recordOfTheSine();
    a.axis = {towards, 0.0};
    a.factor = amplitude;
    return a;
}

struct Shaken {
    double slid = 0.0;  // [m] slip down the slope
    std::vector<double> ux;  // [m] in every history row
};

Shaken shake(const std::optional<Acceleration>& body, const std::optional<Acceleration>& base) {
    Scene scene = inclineScene(planeSlope, friction, duration);
    scene.stages[0].bodyAcceleration = body;
    scene.stages[0].baseAcceleration = base;
    const Solved solved = solve(scene);
    return {slidDown(solved, planeSlope), series(solved, "slider", 0)};
}

/// Slip of a rigid block under gravity and a horizontal acceleration a(t) [m]. Per unit mass, the normal force is N = g
/// cos α − a sin α, and the driving force down the slope is g sin α + a cos α. The block starts to slide when the
/// driving force exceeds N·tan φ and stops when its velocity is zero. It does not slide up the slope.
double slidRigid(double towards) {
    const double a = planeSlope * degree, mu = std::tan(friction * degree);
    const double dt = 1e-5;
    double v = 0.0, s = 0.0;
    for (int i = 0; i < static_cast<int>(std::lround(duration / dt)); ++i) {
        const double t = (i + 0.5) * dt;
        const double shaken = towards * amplitude * std::sin(2.0 * std::numbers::pi * frequency * t);
        const double drive = gravity * std::sin(a) + shaken * std::cos(a);
        const double net = drive - mu * (gravity * std::cos(a) - shaken * std::sin(a));
        const double next = std::max(0.0, v + dt * net);
        s += 0.5 * dt * (v + next);
        v = next;
    }
    return s;
}

double largestDifference(const std::vector<double>& a, const std::vector<double>& b) {
    if (a.size() != b.size() || a.empty()) return std::nan("");
    double largest = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
    return largest;
}

std::vector<CaseResult> shakenIncline() {
    Checks checks("shaken incline");
    checks.relative("rigid block [m]", slidRigid(1.0), 0.3008, 1e-3);
    checks.relative("rigid block, reversed [m]", slidRigid(-1.0), 0.2836, 1e-3);
    const Shaken body = shake(sineAcceleration(1.0), std::nullopt);
    checks.relative("slip in 5 s, sine on the body [m]", body.slid, 0.3008, 0.03);
    checks.relative("the same, reversed [m]", shake(sineAcceleration(-1.0), std::nullopt).slid, 0.2836, 0.03);
    const Shaken base = shake(std::nullopt, sineAcceleration(-1.0));
    checks.relative("slip in 5 s, sine of the ground [m]", base.slid, 0.3008, 0.03);
    checks.absolute("ground against body, largest difference during motion [m]", largestDifference(base.ux, body.ux), 0.0,
                    1e-12);
    checks.relative("slip in 5 s, record on the body [m]", shake(recordAcceleration(1.0), std::nullopt).slid, 0.3008,
                    0.03);
    checks.relative("slip in 5 s, record of the ground reversed [m]",
                    shake(std::nullopt, recordAcceleration(1.0)).slid, 0.2836, 0.03);
    return checks.take();
}

}  // namespace

std::vector<Case> shakenCases() {
    return {{"shaken incline", "A block on a shaken slope slides down in steps.", shakenIncline}};
}

}  // namespace keyblock
