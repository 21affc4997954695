// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Single blocks, in free flight, on a slope or rotating under their own
// elasticity. The closed-form solutions are given with each case.
#include "solver/verify/checks.h"
#include "solver/verify/groups.h"
#include "solver/verify/readings.h"
#include "solver/verify/scenes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

namespace keyblock {

namespace {

Monitor pointMonitor(const std::string& name, const Point& at) {
    Monitor monitor;
    monitor.name = name;
    monitor.point = at;
    return monitor;
}

Stage dynamicStage(double duration, double timeStep) {
    Stage stage;
    stage.name = "run";
    stage.kind = StageKind::Dynamic;
    stage.duration = duration;
    stage.timeStep = timeStep;
    return stage;
}

/// One free block of 1 m × 1 m, with the monitor `centre`.
Scene loneBlock(double youngsModulus, double poissonsRatio) {
    Scene scene = emptyScene(youngsModulus, poissonsRatio, 30.0);
    scene.blocks = {boxBlock("block", {0, 0}, {1, 1})};
    scene.monitors = {pointMonitor("centre", {0.5, 0.5})};
    return scene;
}

void giveVelocity(Scene& scene, const Point& velocity, double spin) {
    InitialVelocity initial;
    initial.blockAt = {0.5, 0.4};
    initial.velocity = velocity;
    initial.spin = spin;
    scene.stages.back().initialVelocities = {initial};
}

double largestStress(const Results& results) {
    double largest = 0.0;
    for (const Frame& frame : results.frames)
        for (const BlockState& block : frame.blocks)
            for (const double s : block.stress) largest = std::max(largest, std::abs(s));
    return largest;
}

/// y = v0·t − ½·g·t² and x = u0·t. Shi's scheme is exact here because it integrates a constant force without error.
std::vector<CaseResult> projectile(const std::string& name, const Point& velocity) {
    Checks checks(name);
    Scene scene = loneBlock(hardRock, 0.25);
    scene.analysis.gravity = {0.0, -gravity};
    scene.stages = {dynamicStage(1.0, 0.01)};
    giveVelocity(scene, velocity, 0.0);
    const Solved solved = solve(scene);
    const std::vector<double> x = series(solved, "centre", 0), y = series(solved, "centre", 1);
    double worst = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double t = solved.results.history[i].time;
        worst = std::max({worst, std::abs(x[i] - velocity.x() * t),
                          std::abs(y[i] - (velocity.y() * t - 0.5 * gravity * t * t))});
    }
    checks.relative("fall after 1 s [m]", reading(solved, "last centre.uy"), velocity.y() - 0.5 * gravity, 1e-9);
    checks.absolute("largest deviation during the fall [m]", worst, 0.0, 1e-9);
    checks.absolute("largest stress [Pa]", largestStress(solved.results), 0.0, 1e-9 * 2700.0 * gravity);
    return checks.take();
}

/// The slip is s = ½·g·(sin α − cos α·tan φ)·t².
std::vector<CaseResult> slide() {
    Checks checks("incline");
    const double pairs[2][2] = {{30.0, 20.0}, {45.0, 30.0}};
    for (const auto& [slope, friction] : pairs) {
        const double a = slope * degree;
        const double expected =
            0.5 * gravity * (std::sin(a) - std::cos(a) * std::tan(friction * degree)) * 2.0 * 2.0;
        const Solved solved = solve(inclineScene(slope, friction, 2.0));
        checks.relative(slope == 30.0 ? "slip in 2 s at 30°, φ 20° [m]" : "slip in 2 s at 45°, φ 30° [m]",
                        slidDown(solved, slope), expected, 1e-3);
    }
    return checks.take();
}

std::vector<CaseResult> stick() {
    Checks checks("stick");
    for (const auto& [slope, friction, name] : {std::tuple{33.0, 35.0, "33°, φ 35°"}, {30.0, 30.1, "30°, φ 30.1°"}}) {
        const Solved solved = solve(inclineScene(slope, friction, 5.0));
        const double reached = solved.results.stages.empty() ? 0.0 : solved.results.stages.back().time;
        checks.relative(std::string("time reached at ") + name + " [s]", reached, 5.0, 1e-9);
        checks.absolute(std::string("creep in 5 s at ") + name + " [m]", slidDown(solved, slope), 0.0, 1e-6);
    }
    return checks.take();
}

/// The stress of a frame in axes that rotate with the block [Pa].
std::array<double, 3> turnedBack(const BlockState& block) {
    const double c = std::cos(block.rotation), s = std::sin(block.rotation);
    const auto& [x, y, xy] = block.stress;
    return {c * c * x + s * s * y + 2 * c * s * xy, s * s * x + c * c * y - 2 * c * s * xy,
            c * s * (y - x) + (c * c - s * s) * xy};
}

void spinFree(Checks& checks) {
    Scene scene = loneBlock(hardRock, 0.25);
    scene.stages = {dynamicStage(10.0, 0.01)};
    giveVelocity(scene, {0, 0}, 1.0);
    scene.output.every = 0.1;
    const Results results = solve(scene).results;
    double area = 0.0, rate = 0.0;
    for (std::size_t i = 1; i < results.frames.size(); ++i) {
        const Frame &before = results.frames[i - 1], &now = results.frames[i];
        area = std::max(area, std::abs(now.blocks[0].area - 1.0));
        if (now.time > before.time)
            rate = std::max(rate, std::abs((now.blocks[0].rotation - before.blocks[0].rotation) /
                                               (now.time - before.time) - 1.0));
    }
    const bool ran = results.frames.size() > 50;
    checks.absolute("(a) change of area in 1000 steps", ran ? area : std::nan(""), 0.0, 1e-9);
    checks.absolute("(a) change of angular momentum", ran ? rate : std::nan(""), 0.0, 1e-9);
    checks.relative("(a) rotation in 10 s [rad]", ran ? results.frames.back().blocks[0].rotation : std::nan(""), 10.0,
                    1e-9);
}

/// A block under 1 MPa along x makes a quarter turn in 100 steps. The stress is balanced by tractions on two edges,
/// which turn with the block.
void spinStressed(Checks& checks) {
    Scene scene = loneBlock(hardRock, 0.25);
    scene.blocks[0].initialStress = {1e6, 0.0, 0.0};
    const double step = 0.5 * std::numbers::pi / 100.0;
    Stage stage = dynamicStage(100 * step, step);
    for (const double x : {0.0, 1.0}) {
        Load pull;
        pull.along = {Point(x, 0.0), Point(x, 1.0)};
        pull.pressure = -1e6;
        stage.loads.push_back(pull);
    }
    scene.stages = {stage};
    giveVelocity(scene, {0, 0}, 1.0);
    const Results results = solve(scene).results;
    double worst = 0.0;
    for (const Frame& frame : results.frames) {
        const auto [x, y, xy] = turnedBack(frame.blocks[0]);
        worst = std::max({worst, std::abs(x - 1e6), std::abs(y), std::abs(xy)});
    }
    const bool ran = results.frames.size() > 50;
    const auto& last = ran ? results.frames.back().blocks[0].stress : Stress{NAN, NAN, NAN};
    checks.absolute("(b) change of stress in the block's frame [Pa]", ran ? worst : NAN, 0.0, 1e6 * 1e-9);
    checks.absolute("(b) sxx after a quarter turn [Pa]", last[0], 0.0, 1e6 * 1e-9);
    checks.relative("(b) syy after a quarter turn [Pa]", last[1], 1e6, 1e-9);
    checks.absolute("(b) sxy after a quarter turn [Pa]", last[2], 0.0, 1e6 * 1e-9);
}

std::vector<CaseResult> spin() {
    Checks checks("spin");
    spinFree(checks);
    spinStressed(checks);
    return checks.take();
}

}  // namespace

std::vector<Case> blockCases() {
    return {
        {"free fall", "One block under gravity alone, from rest.", [] { return projectile("free fall", {0, 0}); }},
        {"projectile", "The same with a velocity of (3, 4) m/s.", [] { return projectile("projectile", {3, 4}); }},
        {"incline", "A block slides down a slope steeper than its friction.", slide},
        {"stick", "A block on a slope flatter than its friction does not creep.", stick},
        {"spin", "A freely rotating block keeps its area, angular velocity and stress.", spin},
    };
}

}  // namespace keyblock
