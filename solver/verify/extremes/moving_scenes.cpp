// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Scenes in motion whose course follows from mechanics of rigid bodies.
#include "solver/verify/extremes/scene_parts.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace keyblock {

namespace {

using Axes = std::vector<std::string>;

Axes axesOf(std::initializer_list<Axes> lists) {
    Axes all;
    for (const Axes& list : lists) all.insert(all.end(), list.begin(), list.end());
    return all;
}

const Axes placeAxes{"offset", "turn", "mirror", "size", "thickness", "plane"};
const Axes stepAxes{"time-step", "time-step-newmark", "time-step-backward", "time-step-alpha"};
const Axes numberAxes{"penalty", "shear-ratio", "tolerance", "max-passes", "integration", "contact", "iteration"};

double massOf(const Conditions& c, double width = 1.0, double height = 1.0) {
    return c.density * width * height * c.size * c.size * c.thickness;
}

InitialVelocity velocityOf(const Point& blockAt, const Point& velocity, double spin = 0.0) {
    InitialVelocity initial;
    initial.blockAt = blockAt;
    initial.velocity = velocity;
    initial.spin = spin;
    return initial;
}

Point lastVelocity(const Conditions& c, const Solved& solved, std::size_t block) {
    return inOwnAxes(c, lastBlock(solved, block).velocity);
}

// --- rest

Scene movingRest(const Conditions& c) {
    Scene scene = conditionedScene(c);
    addBase(scene, {-2.0 * c.size, -c.size}, {3.0 * c.size, 0.0});
    scene.blocks.push_back(boxBlock("box", {0, 0}, {c.size, c.size}));
    scene.stages = {conditionedMotion(c)};
    return scene;
}

/// Released with contact forces that balance its weight, the box only takes up its own elastic deflection: at most twice
/// the static one.
void judgeMovingRest(const Conditions& c, const Solved& solved, Findings& findings) {
    const double bound = 4.0 * restingDeflection(c), weight = weightOf(c);
    findings.holds("the box is stable", endedWell(solved));
    findings.near("movement, m", moved(c, solved, 1).norm(), 0.0, bound);
    findings.near("rotation", lastBlock(solved, 1).rotation, 0.0, bound / c.size);
    findings.atMost("kinetic energy, J", solved.results.frames.back().energy.kinetic, 0.0, weight * bound);
}

// --- a slide

double slideAcceleration(const Conditions& c) {
    const double a = c.slope * degree;
    return std::max(0.0, c.gravity * (std::sin(a) - std::cos(a) * std::tan(c.friction * degree)));
}

/// Way that may be lost in the digits of coordinates over all steps [m].
double roundOff(const Conditions& c) { return 2.3e-16 * c.size * std::round(c.steps); }

double slideTime(const Conditions& c) { return c.timeStep * std::round(c.steps); }

Scene slide(const Conditions& c) {
    Scene scene = conditionedScene(c);
    const double a = c.slope * degree;
    const double run = 0.5 * slideAcceleration(c) * slideTime(c) * slideTime(c);
    scene.analysis.gravity = {c.gravity * std::sin(a), -c.gravity * std::cos(a)};
    addBase(scene, {-2.0 * c.size, -c.size}, {1.2 * run + 4.0 * c.size, 0.0});
    scene.blocks.push_back(boxBlock("box", {0, 0}, {c.size, 0.5 * c.size}));
    scene.stages = {conditionedMotion(c)};
    return scene;
}

/// s = ½·g·(sin α − cos α·tan φ)·t², and no movement where the slope is less than the friction angle; either way up to
/// the elastic deflections of contacts and box.
void judgeSlide(const Conditions& c, const Solved& solved, Findings& findings) {
    const double t = lastTime(solved), expected = 0.5 * slideAcceleration(c) * t * t;
    const double elastic = restingDeflection(c) * (2.0 + 2.0 / c.shearRatio);
    // backward Euler takes the velocity at the end of each step
    const double lag = c.integration == Integration::BackwardEuler ? 1.0 / std::round(c.steps) : 0.0;
    findings.holds("the box slides until the end", endedWell(solved));
    findings.near("way down the slope, m", moved(c, solved, 1).x(), expected * (1.0 + lag),
                  5e-3 * expected + elastic + roundOff(c));
    findings.near("rotation", lastBlock(solved, 1).rotation, 0.0, elastic / c.size + 1e-6);
}

/// Neither near the angle at which it would topple, nor so steep that the box is hardly pressed to the slope.
bool slideApplies(const Conditions& c) {
    return std::min(std::tan(c.friction * degree), std::tan(c.slope * degree)) < 1.7 && c.cohesion == 0.0;
}

// --- a fall

Scene fall(const Conditions& c) {
    Scene scene = conditionedScene(c);
    scene.blocks = {boxBlock("box", {0, 0}, {c.size, c.size})};
    scene.stages = {conditionedMotion(c)};
    scene.stages[0].initialVelocities = {velocityOf({0.5 * c.size, 0.4 * c.size}, {c.speed, 0.0})};
    return scene;
}

/// y = −½·g·t²; backward Euler gives −½·g·t·(t + Δt). x = v·t.
void judgeFall(const Conditions& c, const Solved& solved, Findings& findings) {
    const double t = lastTime(solved), dt = c.integration == Integration::BackwardEuler ? c.timeStep : 0.0;
    const double expected = 0.5 * c.gravity * t * (t + dt), along = c.speed * t;
    const Point u = moved(c, solved, 0);
    const double allowed = 1e-9 * (std::abs(expected) + std::abs(along)) + 1e-13 * (c.size + std::abs(c.offset));
    findings.holds("the block falls until the end", endedWell(solved));
    findings.near("fall, m", -u.y(), expected, allowed);
    findings.near("way, m", u.x(), along, allowed);
}

// --- a spin

Scene spin(const Conditions& c) {
    Scene scene = fall(c);
    scene.analysis.gravity = {0.0, 0.0};
    scene.stages[0].initialVelocities = {velocityOf({0.5 * c.size, 0.4 * c.size}, {0.0, 0.0}, c.speed)};
    return scene;
}

/// The angle is ω·t and the area is kept, up to the square of the strain of the centrifugal forces.
void judgeSpin(const Conditions& c, const Solved& solved, Findings& findings) {
    const double t = lastTime(solved), turn = (c.mirrored ? -1.0 : 1.0) * c.speed * t;
    const double strain = c.density * std::pow(c.speed * c.size, 2) / c.modulus;
    findings.holds("the block turns until the end", endedWell(solved));
    findings.near("angle", lastBlock(solved, 0).rotation, turn, (1e-8 + 2.0 * strain) * std::abs(turn) + 1e-12);
    findings.near("area over its own", lastBlock(solved, 0).area / (c.size * c.size), 1.0, 1e-8 + 2.0 * strain);
}

/// With a spring against the spin that is stiff enough: centrifugal strains beyond that are not small.
bool spinApplies(const Conditions& c) { return c.density * std::pow(c.speed * c.size, 2) < 1e-2 * c.modulus; }

/// Longest duration of an impact: several times that in which waves cross the block, or in which it swings on its
/// contacts [s].
double longestImpact(const Conditions& c) {
    const double softest = c.modulus * std::min(1.0, c.contrast) * std::min(1.0, c.penalty);
    return 8.0 * c.size * std::sqrt(c.density / softest) + 3.0 * c.timeStep;
}

/// Strain of rock in an impact.
double impactStrain(const Conditions& c) {
    return c.speed * std::sqrt(c.density / (c.modulus * std::min(1.0, c.contrast)));
}

// --- a collision

Scene collision(const Conditions& c) {
    Scene scene = conditionedScene(c);
    scene.analysis.gravity = {0.0, 0.0};
    const double gap = 0.3 * c.speed * slideTime(c);
    scene.blocks = {boxBlock("first", {0, 0}, {c.size, c.size}),
                    boxBlock("second", {c.size + gap, 0.0}, {c.size + gap + c.size, c.size})};
    scene.blocks[1].material = "base";
    scene.stages = {conditionedMotion(c)};
    scene.stages[0].initialVelocities = {velocityOf({0.5 * c.size, 0.4 * c.size}, {c.speed, 0.0})};
    return scene;
}

/// Momentum is kept, kinetic energy is not gained, and the first block does not pass through the second.
void judgeCollision(const Conditions& c, const Solved& solved, Findings& findings) {
    const Point a = lastVelocity(c, solved, 0), b = lastVelocity(c, solved, 1);
    const double share = std::max(1e-5, c.tolerance * 0.1);
    findings.holds("the blocks move until the end", endedWell(solved));
    findings.near("momentum over that at the start", (a.x() + b.x()) / c.speed, 1.0, share);
    findings.near("momentum across over that at the start", (a.y() + b.y()) / c.speed, 0.0, share);
    findings.atMost("kinetic energy over that at the start", (a.squaredNorm() + b.squaredNorm()) / (c.speed * c.speed),
                    1.0, 1e-3);
    // it has come to the second block at 0.3 of the time, and cannot be beyond it
    const double gap = 0.3 * c.speed * slideTime(c);
    const double ahead = (moved(c, solved, 1) - moved(c, solved, 0)).x() + gap;
    findings.atMost("overlap over the size", -ahead / c.size, 0.0, 0.02 + impactStrain(c));
    if (0.7 * slideTime(c) > longestImpact(c))
        findings.near("velocity of the second block over that of the first", b.x() / c.speed, 0.75, 0.26);
}

// --- an impact on the floor

Scene impact(const Conditions& c) {
    Scene scene = conditionedScene(c);
    scene.analysis.gravity = {0.0, 0.0};
    const double gap = 0.5 * c.speed * slideTime(c);
    addBase(scene, {-3.0 * c.size, -c.size}, {4.0 * c.size, 0.0});
    scene.blocks.push_back(boxBlock("box", {0, gap}, {c.size, gap + c.size}));
    scene.stages = {conditionedMotion(c)};
    scene.stages[0].initialVelocities = {velocityOf({0.5 * c.size, gap + 0.4 * c.size}, {0.0, -c.speed})};
    return scene;
}

/// It rebounds at no more than the speed of its impact, without turning, and does not enter the floor by more than the
/// way in which contacts and rock take up its energy.
void judgeImpact(const Conditions& c, const Solved& solved, Findings& findings) {
    const Point v = lastVelocity(c, solved, 1);
    const double below = -(moved(c, solved, 1).y() + 0.5 * c.speed * slideTime(c));
    const double taken = c.speed * std::sqrt(massOf(c) / (2.0 * contactStiffness(c))) +
                         c.speed * c.size * std::sqrt(c.density / c.modulus);
    findings.holds("the box moves until the end", endedWell(solved));
    findings.atMost("speed over that of the impact", v.norm() / c.speed, 1.0, 1e-3);
    if (0.5 * slideTime(c) > longestImpact(c))
        findings.holds("the box does not fall any more", v.y() > -0.05 * c.speed);
    findings.atMost("depth in the floor over the size", below / c.size, 0.0,
                    std::min(0.1, 1.5 * taken / c.size) + 1e-9);
    findings.near("rotation", lastBlock(solved, 1).rotation, 0.0, 1e-3 + 0.1 * taken / c.size);
}

// --- a pendulum

constexpr double halfSwing = 5.0;  // [°]

double pendulumFrequency(const Conditions& c) {
    // pinned at the middle of its upper edge: I = m·L²/6 + m·L²/4, torque m·g·L/2
    return std::sqrt(c.gravity * 0.5 * c.size / ((1.0 / 6.0 + 0.25) * c.size * c.size));
}

Scene pendulum(const Conditions& c) {
    Scene scene = conditionedScene(c);
    const double a = halfSwing * degree;
    scene.analysis.gravity = {c.gravity * std::sin(a), -c.gravity * std::cos(a)};
    scene.blocks = {boxBlock("box", {-0.5 * c.size, -c.size}, {0.5 * c.size, 0.0})};
    Support pin;
    pin.point = Point(0.0, -1e-3 * c.size);
    pin.fix = Fix::XY;
    scene.supports = {pin};
    scene.stages = {conditionedMotion(c)};
    return scene;
}

/// A physical pendulum: θ = θ0·(1 − cos Ωt), and never beyond its first swing.
void judgePendulum(const Conditions& c, const Solved& solved, Findings& findings) {
    const double omega = pendulumFrequency(c), a = halfSwing * degree, sense = c.mirrored ? -1.0 : 1.0;
    findings.holds("the block swings until the end", endedWell(solved));
    const double t = lastTime(solved);
    const double expected = a * (1.0 - std::cos(omega * t));
    // backward Euler loses amplitude by exp(−Ω²·t·Δt/2)
    const bool loses = c.integration == Integration::BackwardEuler;
    const double lost = loses ? a * (1.0 - std::exp(-0.5 * omega * omega * t * c.timeStep)) : 0.0;
    const double late = a * std::min(1.0, std::pow(omega * t, 1) * std::pow(omega * c.timeStep, 2) / 6.0);
    findings.near("angle", sense * lastBlock(solved, 0).rotation, expected,
                  0.02 * a + 1.5 * lost + late + 0.01 * a * omega * t / (2.0 * std::numbers::pi));
    for (const Frame& frame : solved.results.frames)
        findings.atMost("angle of a swing over the first", std::abs(sense * frame.blocks[0].rotation - a) / a, 1.0,
                        0.02);
}

bool pendulumApplies(const Conditions& c) { return pendulumFrequency(c) * slideTime(c) < 20.0; }

// --- many steps at rest

Scene longRest(const Conditions& c) {
    Scene scene = movingRest(c);
    scene.stages[0].duration = c.timeStep * std::round(c.ratio);
    return scene;
}

}  // namespace

std::vector<KnownScene> movingScenes() {
    Conditions sliding;
    sliding.slope = 30.0;
    sliding.friction = 20.0;
    Conditions smooth;
    smooth.friction = 0.0;
    Conditions spinning;
    spinning.gravity = 0.0;
    Conditions swinging;
    swinging.timeStep = 5e-3;
    Conditions resting;
    resting.ratio = 1000.0;
    const Axes rock{"modulus", "density"};
    return {
        {"still",
         "a box at rest on a slab, in motion",
         "it moves by no more than twice its elastic deflection",
         {},
         axesOf({stepAxes, numberAxes, placeAxes, rock, {"contrast", "friction", "gravity", "damping"}}),
         movingRest,
         judgeMovingRest},
        {"slide", "a box slides down an incline", "s = ½g(sin α − cos α tan φ)t²", sliding,
         axesOf({stepAxes, numberAxes, placeAxes, rock, {"contrast", "friction", "slope", "gravity"}}), slide,
         judgeSlide, slideApplies},
        {"fall",
         "a block in free flight",
         "y = −½gt², x = vt",
         {},
         axesOf({stepAxes, {"speed", "steps", "tolerance", "integration"}, placeAxes, rock, {"gravity"}}),
         fall,
         judgeFall},
        {"spin", "a free block that turns", "angle = ωt, area kept", spinning,
         axesOf({stepAxes, {"spin", "integration", "tolerance"}, placeAxes, rock}), spin, judgeSpin, spinApplies},
        {"collision", "a block hits another", "momentum kept, no energy gained, no passing through", smooth,
         axesOf({stepAxes, numberAxes, placeAxes, rock, {"speed"}}), collision, judgeCollision},
        {"impact", "a block hits a fixed slab", "no energy gained, no passing through, no rotation", smooth,
         axesOf({stepAxes, numberAxes, placeAxes, rock, {"speed", "contrast", "friction"}}), impact, judgeImpact},
        {"pendulum", "a block swings on a pin", "θ = θ₀(1 − cos Ωt)", swinging,
         axesOf({stepAxes, {"penalty", "tolerance", "integration", "steps"}, placeAxes, rock, {"gravity"}}), pendulum,
         judgePendulum, pendulumApplies},
        {"long-rest",
         "a box at rest for many steps",
         "it moves by no more than twice its elastic deflection",
         resting,
         {"number-of-steps"},
         longRest,
         judgeMovingRest},
    };
}

}  // namespace keyblock
