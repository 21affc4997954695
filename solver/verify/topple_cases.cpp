// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A slope of columns that topple onto one another and push out its toe. The
// limit equilibrium of the columns is computed for comparison.
#include "solver/verify/bisection.h"
#include "solver/verify/checks.h"
#include "solver/verify/groups.h"
#include "solver/verify/readings.h"
#include "solver/verify/scenes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace keyblock {

namespace {

constexpr double baseDip = 30.0 * degree, columnWeight = 25e3;  // [N/m³]
constexpr double columnWidth = 10.0, baseRise = 1.0;  // [m]; `baseRise`: from one base to the next one upslope
constexpr std::array<double, 16> heights{4,  8,  12, 16, 20, 24, 28, 32,
                                         36, 40, 34, 28, 22, 16, 10, 4};  // [m] from the toe to the crest
constexpr int columns = static_cast<int>(heights.size());
constexpr double watched = 1.5;  // [s]
// [m/s] final speed above which a column counts as moving; columns of a stable slope are at least a hundred times
// slower
constexpr double moving = 0.05;

/// Height of the top of a column above the lowest base, normal to the bases [m].
double topOfColumn(int n) { return baseRise * n + heights[n]; }

/// The external force that the toe needs at a coefficient of friction `tangent`, divided by the unit weight (Goodman
/// and Bray 1976). From the crest down, each column passes on the force that prevents it from toppling about its lower
/// corner or from sliding, whichever is larger. Neighbours touch at the lower of their tops, where friction is fully
/// mobilised. A toppling column rests on its corner.
double forceAtToe(double tangent) {
    const double s = std::sin(baseDip), c = std::cos(baseDip);
    double push = 0.0;
    for (int n = columns - 1; n >= 0; --n) {
        const double height = heights[n], weight = columnWidth * height, base = baseRise * n;
        const double slides = push - weight * (c * tangent - s) / (1.0 - tangent * tangent);
        double topples = 0.0;
        if (n > 0) {
            const double above = n + 1 < columns ? std::min(topOfColumn(n), topOfColumn(n + 1)) - base : 0.0;
            const double below = std::min(topOfColumn(n), topOfColumn(n - 1)) - base;
            topples = (push * (above - columnWidth * tangent) + 0.5 * weight * (height * s - columnWidth * c)) / below;
        }
        push = n > 0 ? std::max({topples, slides, 0.0}) : slides;
    }
    return push;
}

/// Friction angle at which the toe needs no external force [°].
double criticalAngle() {
    double low = 35.0, high = 42.0;
    while (high - low > 1e-6) {
        const double middle = 0.5 * (low + high);
        (forceAtToe(std::tan(middle * degree)) > 0.0 ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

/// The columns are vertical and stand on fixed steps. Gravity is inclined by the dip of the bases instead.
Scene slopeScene(double frictionAngle) {
    Scene scene = emptyScene(60e9, 0.25, frictionAngle);
    scene.analysis.gravity = {-gravity * std::sin(baseDip), -gravity * std::cos(baseDip)};
    scene.materials[0].second.density = columnWeight / gravity;
    for (int n = 0; n < columns; ++n) {
        const double left = columnWidth * n, base = baseRise * n;
        const double from = n == 0 ? -3.0 * columnWidth : left;  // the toe slides out on the lowest step
        scene.blocks.push_back(
            boxBlock("step " + std::to_string(n + 1), {from, -2.0 * columnWidth}, {left + columnWidth, base}));
        Support support;
        support.blockAt = Point(left + 0.5 * columnWidth, -columnWidth);
        scene.supports.push_back(support);
    }
    for (int n = 0; n < columns; ++n)
        scene.blocks.push_back(
            boxBlock(std::to_string(n + 1), {columnWidth * n, baseRise * n}, {columnWidth * (n + 1), topOfColumn(n)}));
    Stage stage;
    stage.name = "gravity";
    stage.kind = StageKind::Dynamic;
    stage.duration = watched;
    stage.timeStep = 0.01;
    scene.stages = {stage};
    scene.output.frames = 10;
    return scene;
}

/// Energy balance error of a stable slope at the end of the run, relative to the largest energy. At its high friction
/// angle, joints carry shear from the first step on, and they must not release energy that was never supplied.
double energyLeft(double frictionAngle) {
    return std::abs(solve(slopeScene(frictionAngle)).results.stages.back().health.balanceError);
}

/// The columns at the end of the run; empty if the run ended early.
std::vector<BlockState> columnsAtEnd(double frictionAngle) {
    const Results results = solve(slopeScene(frictionAngle)).results;
    if (results.stages.empty() || results.stages.back().outcome != Outcome::Duration) return {};
    const std::vector<BlockState>& all = results.frames.back().blocks;
    return {all.end() - columns, all.end()};
}

/// 1 if the slope comes to rest, 0 if it keeps moving.
double stands(double frictionAngle) {
    const std::vector<BlockState> all = columnsAtEnd(frictionAngle);
    if (all.empty()) return std::nan("");
    double fastest = 0.0;
    for (const BlockState& column : all) fastest = std::max(fastest, column.velocity.norm());
    return fastest < moving ? 1.0 : 0.0;
}

enum class Way { Stands, Slides, Topples, Neither };

Way wayOf(const BlockState& column) {
    const double turned = std::abs(column.rotation), moved = column.displacement.norm();
    if (turned > 0.5 * degree) return Way::Topples;
    if (turned > 0.05 * degree) return Way::Neither;
    return moved > 0.1 ? Way::Slides : moved < 0.01 ? Way::Stands : Way::Neither;
}

/// Number of columns that move as predicted by limit equilibrium: the lowest three slide, the highest three stand, and
/// the others topple.
double asExpected(double frictionAngle) {
    const std::vector<BlockState> all = columnsAtEnd(frictionAngle);
    int found = 0;
    for (int n = 0; n < static_cast<int>(all.size()); ++n) {
        const Way expected = n < 3 ? Way::Slides : n < 13 ? Way::Topples : Way::Stands;
        found += wayOf(all[n]) == expected ? 1 : 0;
    }
    return found;
}

/// Applies gravity suddenly and follows the motion. Shi's scheme damps the oscillations of stable columns.
std::vector<CaseResult> slope() {
    Checks checks("toppling slope");
    const double published = std::atan(0.7854) / degree;
    checks.absolute("limit equilibrium [°]", criticalAngle(), published, 0.05);
    const double found = boundaryOf(36.0, 40.0, 0.25, stands);
    checks.absolute("friction angle below which it fails [°]", found, published, 2.0);
    checks.absolute("columns of 16 that correctly stand, topple or slide, at 37.25°", asExpected(37.25), 16.0,
                    0.0);
    checks.absolute("energy created by the numerical solution, at 60°", energyLeft(60.0), 0.0, 1e-6);
    return checks.take();
}

}  // namespace

std::vector<Case> toppleCases() {
    return {{"toppling slope", "Sixteen columns on steps topple and push the toe of the slope out.", slope}};
}

}  // namespace keyblock
