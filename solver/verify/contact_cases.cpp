// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Blocks in contact: what a collision conserves, how a block on a slope starts
// to move, and the period of a rocking block. The closed-form solutions are
// given with each case.
#include "solver/verify/checks.h"
#include "solver/verify/groups.h"
#include "solver/verify/readings.h"
#include "solver/verify/scenes.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace keyblock {

namespace {

constexpr double rockDensity = 2700.0;  // [kg/m³] of the rock in the verification scenes
constexpr double modesSeen = 0.1;  // [s] after which the mode of motion is determined
constexpr double moved = 5e-5;  // [m, rad] smaller movements are elastic

Stage motion(double duration, double timeStep) {
    Stage stage;
    stage.name = "motion";
    stage.kind = StageKind::Dynamic;
    stage.duration = duration;
    stage.timeStep = timeStep;
    return stage;
}

void push(Scene& scene, std::size_t block, const Point& velocity, double spin) {
    InitialVelocity initial;
    initial.blockAt = 0.5 * (scene.blocks[block].points[0] + scene.blocks[block].points[2]);
    initial.velocity = velocity;
    initial.spin = spin;
    scene.stages.back().initialVelocities.push_back(initial);
}

/// Two free squares of 1 m. The second one lies 1 mm to the right of the first and is `offset` [m] higher.
Scene twoSquares(double offset) {
    Scene scene = emptyScene(hardRock, 0.25, 0.0);
    scene.blocks = {boxBlock("left", {0, 0}, {1, 1}), boxBlock("right", {1.001, offset}, {2.001, 1 + offset})};
    scene.stages = {motion(0.02, 1e-4)};
    scene.output.every = 1e-4;
    return scene;
}

/// Linear momentum, and angular momentum about the origin, from the last two frames. The blocks are then in free flight
/// and rotate at constant rates; squares do not couple spin and strain.
struct Momenta {
    Point linear{0.0, 0.0};
    double angular = 0.0;
    double largestSpin = 0.0;  // [rad/s]
};

Momenta momentaAtEnd(const Results& results) {
    Momenta sum;
    const Frame &last = results.frames.back(), &before = results.frames[results.frames.size() - 2];
    for (std::size_t i = 0; i < last.blocks.size(); ++i) {
        const BlockState& block = last.blocks[i];
        const double spin = (block.rotation - before.blocks[i].rotation) / (last.time - before.time);
        sum.linear += rockDensity * block.velocity;
        sum.angular += rockDensity * (cross(block.centroid, block.velocity) + spin / 6.0);
        sum.largestSpin = std::max(sum.largestSpin, std::abs(spin));
    }
    return sum;
}

void collide(Checks& checks, const std::string& name, const Scene& scene, const Point& linear, double angular) {
    const Solved solved = solve(scene);
    const Momenta after = momentaAtEnd(solved.results);
    const double scale = std::max(linear.norm(), rockDensity);
    const double slower = solved.results.frames.back().blocks[0].velocity.x();
    const bool met = slower < 0.9 * scene.stages[0].initialVelocities[0].velocity.x();
    checks.absolute(name + ": the blocks collided", met ? 1.0 : 0.0, 1.0, 0.0);
    checks.absolute(name + ": momentum lost, relative to its initial value", (after.linear - linear).norm() / scale, 0.0, 1e-9);
    checks.absolute(name + ": angular momentum lost, likewise", (after.angular - angular) / scale, 0.0, 1e-9);
}

std::vector<CaseResult> freeCollision() {
    Checks checks("free collision");
    Scene flat = twoSquares(0.0);
    push(flat, 0, {1.0, 0.0}, 0.0);
    checks.absolute("flat: spin [rad/s]", momentaAtEnd(solve(flat).results).largestSpin, 0.0, 1e-9);
    collide(checks, "flat", flat, rockDensity * Point(1.0, 0.0), -0.5 * rockDensity);

    Scene offset = twoSquares(0.6);
    push(offset, 0, {1.0, 0.0}, 0.0);
    collide(checks, "off centre", offset, rockDensity * Point(1.0, 0.0), -0.5 * rockDensity);

    Scene grazing = twoSquares(0.3);
    push(grazing, 0, {1.0, 0.7}, 0.5);
    push(grazing, 1, {-0.4, -0.2}, 0.0);
    const Point left = rockDensity * Point(1.0, 0.7), right = rockDensity * Point(-0.4, -0.2);
    collide(checks, "turning, past each other", grazing, left + right,
            cross(Point(0.5, 0.5), left) + cross(Point(1.501, 0.8), right) + rockDensity * 0.5 / 6.0);
    return checks.take();
}

/// A block `breadth` wide and 1 m high on a fixed plane that dips by `slope`° to the right. The plane is drawn
/// horizontal, and gravity is inclined instead.
Scene blockOnSlope(double breadth, double slope, double frictionAngle) {
    Scene scene = emptyScene(hardRock, 0.25, frictionAngle);
    scene.analysis.gravity = {gravity * std::sin(slope * degree), -gravity * std::cos(slope * degree)};
    scene.blocks = {boxBlock("plane", {-2, -1}, {6, 0}), boxBlock("block", {0, 0}, {breadth, 1})};
    Support support;
    support.blockAt = Point(1.0, -0.5);
    scene.supports = {support};
    Monitor toe;
    toe.name = "toe";
    toe.point = Point(breadth - 1e-3, 1e-3);  // inside the block; at the corner itself, the plane would be monitored
    scene.monitors = {toe};
    scene.stages = {motion(modesSeen, 1e-3)};
    return scene;
}

/// Mode of motion: 1 if the toe slides, plus 2 if the block rotates.
double modeOf(double breadth, double slope, double frictionAngle) {
    const Solved solved = solve(blockOnSlope(breadth, slope, frictionAngle));
    const double slid = std::abs(reading(solved, "last toe.ux"));
    const double turned = std::abs(solved.results.frames.back().blocks[1].rotation);
    return (slid > moved ? 1.0 : 0.0) + (turned > moved ? 2.0 : 0.0);
}

/// A block with b/h = 0.3 on a slope of 30°. If its toe slips, the block rotates only if friction produces a moment,
/// tan φ > b/h (16.70°). It rotates without slip if friction holds the toe of the rotating block, above 20.08°. A block
/// with b/h = 0.7 is stable if φ > 30° (Sagaseta 1986; Yeung 1991).
std::vector<CaseResult> modes() {
    Checks checks("sliding and toppling");
    for (const auto& [friction, text, mode] :
         {std::tuple{16.20, "16.20° (slides)", 1.0}, {17.20, "17.20° (slides and topples)", 3.0},
          {19.58, "19.58° (slides and topples)", 3.0}, {20.58, "20.58° (topples)", 2.0}})
        checks.absolute(std::string("mode at b/h 0.3, φ ") + text, modeOf(0.3, 30.0, friction), mode, 0.0);
    checks.absolute("mode at b/h 0.7, φ 35° (stable)", modeOf(0.7, 30.0, 35.0), 0.0, 0.0);
    return checks.take();
}

/// A block with a half-width of 0.25 m and a half-height of 1 m is released on its corner at half of the critical tilt
/// α = atan ¼. With the distance R from the corner to the centroid, (4/3)·R·θ″ = −g·sin(α − θ). The quarter period is
/// therefore the integral from 0 to θ₀ of dθ / √((3g/2R)(cos(α − θ₀) − cos(α − θ))), which is 0.49380 s (linearised by
/// Housner 1963: 0.4929 s).
std::vector<CaseResult> rocking() {
    Checks checks("rocking block");
    const double tilt = 0.5 * std::atan(0.25);
    Scene scene = emptyScene(hardRock, 0.25, 60.0);
    scene.analysis.gravity = {0.0, -gravity};
    scene.blocks = {boxBlock("floor", {-3, -1}, {3, 0}), boxBlock("block", {0, 0}, {0.5, 2})};
    for (Point& p : scene.blocks[1].points)
        p = Point(std::cos(tilt) * p.x() - std::sin(tilt) * p.y(), std::sin(tilt) * p.x() + std::cos(tilt) * p.y());
    Support support;
    support.blockAt = Point(0.0, -0.5);
    scene.supports = {support};
    scene.stages = {motion(0.7, 1e-3)};
    scene.output.every = 1e-3;
    const Results results = solve(scene).results;
    double quarter = std::nan("");
    for (std::size_t i = 1; i < results.frames.size() && std::isnan(quarter); ++i) {
        const Frame &before = results.frames[i - 1], &now = results.frames[i];
        const double r0 = tilt + before.blocks[1].rotation, r1 = tilt + now.blocks[1].rotation;
        if (r1 <= 0.0) quarter = before.time + (now.time - before.time) * r0 / (r0 - r1);
    }
    checks.relative("quarter period [s]", quarter, 0.4938, 0.02);
    return checks.take();
}

}  // namespace

std::vector<Case> contactCases() {
    return {
        {"free collision", "Two free blocks without friction keep momentum and angular momentum.", freeCollision},
        {"sliding and toppling", "A block on a slope slides, topples, does both or neither.", modes},
        {"rocking block", "A stiff block rocks about its corner from half of the critical tilt.", rocking},
    };
}

}  // namespace keyblock
