// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The time integration schemes, applied to problems with a single frequency: a
// strain mode, an impact on a spring, a weight suspended from a bar and a
// vibrating bar.
#include "solver/verify/checks.h"
#include "solver/verify/groups.h"
#include "solver/verify/mode.h"
#include "solver/verify/readings.h"
#include "solver/verify/scenes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace keyblock {

namespace {

Stage dynamicStage(Integration integration, double duration, double timeStep) {
    Stage stage;
    stage.name = "run";
    stage.kind = StageKind::Dynamic;
    stage.duration = duration;
    stage.timeStep = timeStep;
    stage.integration = integration;
    return stage;
}

void throwBlock(Scene& scene, const Point& blockAt, const Point& velocity) {
    InitialVelocity initial;
    initial.blockAt = blockAt;
    initial.velocity = velocity;
    scene.stages.back().initialVelocities = {initial};
}

std::string shortNumber(double value) {
    std::string text = std::to_string(value);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text;
}

std::vector<CaseResult> schemesDamping() {
    Checks checks("scheme's damping");
    const auto compare = [&](const std::string& name, const ModeSetting& setting) {
        checks.relative(name + ", amplitude kept per step at η " + shortNumber(setting.eta),
                        spectralRadius(modeSeries(setting), stepsRemembered(setting)), closedRadius(setting), 1e-3);
    };
    for (const double eta : {0.1, 0.5, 2.0, 100.0}) compare("Shi", {.scheme = Integration::Shi, .eta = eta});
    for (const double eta : {0.1, 2.0, 100.0}) compare("backward Euler", {.scheme = Integration::BackwardEuler, .eta = eta});
    for (const double eta : {0.1, 2.0, 100.0}) compare("Newmark", {.scheme = Integration::Newmark, .eta = eta});
    for (const double rho : {0.0, 0.5, 0.8, 1.0})
        for (const double eta : {0.1, 1.0, 100.0})
            compare("generalized-α, ρ∞ " + shortNumber(rho),
                    {.scheme = Integration::GeneralizedAlpha, .rhoInf = rho, .eta = eta});
    return checks.take();
}

std::vector<CaseResult> rayleigh() {
    Checks checks("Rayleigh damping");
    for (const auto& [scheme, name] : {std::pair{Integration::Shi, "Shi"}, {Integration::BackwardEuler, "backward Euler"},
                                       {Integration::Newmark, "Newmark"},
                                       {Integration::GeneralizedAlpha, "generalized-α"}})
        for (const auto& [mass, stiffness] : {std::pair{0.1, 0.0}, {0.0, 0.1}}) {
            const ModeSetting setting{.scheme = scheme, .eta = 0.1, .massShare = mass, .stiffnessShare = stiffness};
            checks.relative(std::string(name) + (mass > 0.0 ? ", 10 % by mass" : ", 10 % by stiffness") +
                                ", amplitude kept per step at η 0.1",
                            spectralRadius(modeSeries(setting), stepsRemembered(setting)), closedRadius(setting), 1e-6);
        }
    // e^(−ζη) is the decay due to the damping itself; the decay due to the scheme is of second order
    const ModeSetting fine{.scheme = Integration::Newmark, .eta = 0.02, .stiffnessShare = 0.05};
    checks.relative("Newmark, 5 % by stiffness, decay per step against e^(−ζη) at η 0.02",
                    spectralRadius(modeSeries(fine), 2), std::exp(-0.05 * 0.02), 1e-6);
    return checks.take();
}

/// A stiff block hits springs of η = Δt·√(Σkn/m) at 1 m/s, without gravity.
Scene impact(Integration integration, double eta) {
    Scene scene = emptyScene(rigidRock, 0.0, 0.0);
    scene.analysis.penaltyRatio = 1e-5;
    scene.blocks = {boxBlock("floor", {-1, -1}, {2, 0}), boxBlock("block", {0, 0}, {1, 1})};
    Support support;
    support.blockAt = Point(0.5, -0.5);
    scene.supports = {support};
    const double step = eta * std::sqrt(2700.0 / (2.0 * *scene.analysis.penaltyRatio * rigidRock));
    const double contact = std::numbers::pi / eta;  // number of steps
    scene.stages = {dynamicStage(integration, std::ceil(3.0 * contact + 10.0) * step, step)};
    throwBlock(scene, {0.5, 0.4}, {0.0, -1.0});
    scene.output.every = step;
    return scene;
}

double restitution(const Results& results) {
    return results.frames.size() < 10 ? std::nan("") : results.frames.back().blocks[1].velocity.y();
}

/// Largest sum of kinetic and stored energy, divided by the energy at the start.
double mostEnergy(const Results& results) {
    double most = 0.0;
    for (const Frame& frame : results.frames)
        most = std::max(most, frame.energy.kinetic + frame.energy.strain + frame.energy.contact);
    return results.frames.size() < 10 ? std::nan("") : most / (0.5 * 2700.0);
}

std::vector<CaseResult> impacts() {
    Checks checks("impact");
    for (const auto& [eta, expected] : {std::pair{0.1, 0.9257}, {0.5, 0.7046}})
        checks.relative("Shi, speed after over before at η " + shortNumber(eta),
                        restitution(solve(impact(Integration::Shi, eta)).results), expected, 0.03);
    for (const double eta : {0.1, 0.5, 5.0}) {
        const Results results = solve(impact(Integration::Newmark, eta)).results;
        checks.absolute("Newmark, speed after over before at η " + shortNumber(eta), restitution(results), 1.0, 0.01);
        checks.absolute("Newmark, gain of energy at η " + shortNumber(eta), std::max(0.0, mostEnergy(results) - 1.0), 0.0,
                        1e-12);
    }
    return checks.take();
}

/// A block suspended from a fixed one by a bar of 1.8 m with stiff ends; +x points down.
Scene hung(double weight, double speed) {
    Scene scene = emptyScene(rigidRock, 0.0, 0.0);
    scene.materials[0].second.density = weight / gravity;
    scene.blocks = {boxBlock("roof", {0, 0}, {1, 1}), boxBlock("weight", {2.8, 0}, {3.8, 1})};
    Support support;
    support.blockAt = Point(0.5, 0.1);
    scene.supports = {support};
    scene.analysis.gravity = {gravity, 0.0};
    BoltType bar = linearType(barArea(), 200e9);
    bar.density = 1.0;
    bar.bending = Bending::None;
    bar.anchors = {anchorAt(0.0, AnchorLaw::Elastic, 1e13), anchorAt(1.8, AnchorLaw::Elastic, 1e13)};
    addBolt(scene, bar, 1.0 - 1e-3, 2.8 + 1e-3, 20, PlateKind::None);
    scene.monitors.back().at = 0.9 + 1e-3;
    scene.monitors.back().name = "force";
    const double frequency = std::sqrt(200e9 * barArea() / 1.802 * gravity / weight);
    scene.stages = {dynamicStage(Integration::Newmark, 4.0 / frequency, 0.04 / frequency)};
    if (speed > 0.0) throwBlock(scene, {3.3, 0.1}, {speed, 0.0});
    return scene;
}

std::vector<CaseResult> suddenLoad() {
    Checks checks("sudden load");
    const double weight = 20e3;
    checks.relative("(a) released from rest: largest force at mid-shank over the weight",
                    reading(solve(hung(weight, 0.0)), "max force") / weight, 2.0, 0.02);
    checks.relative("(b) arriving at 0.9905 m/s: largest force at mid-shank over the weight",
                    reading(solve(hung(weight, 0.9905)), "max force") / weight, 14.25, 0.02);
    return checks.take();
}

/// A bar of 2 m with one end in a fixed block. A body force along the bar, applied suddenly, makes it vibrate.
Scene vibratingBar(double timeStep) {
    Scene scene = emptyScene(rigidRock, 0.0, 0.0);
    scene.blocks = {boxBlock("end", {-0.5, 0}, {0.01, 1})};
    Support support;
    support.blockAt = Point(-0.2, 0.1);
    scene.supports = {support};
    scene.analysis.gravity = {1e4, 0.0};
    BoltType bar = linearType(barArea(), 200e9);
    bar.bending = Bending::None;
    bar.anchors = {anchorAt(0.0, AnchorLaw::Elastic, 1e14)};
    addBolt(scene, bar, 0.0, 2.0, 60, PlateKind::None);
    scene.monitors.clear();
    scene.stages = {dynamicStage(Integration::Newmark, 3.2e-3, timeStep)};
    scene.output.every = 1e-4;
    return scene;
}

/// Frequency of the first mode, whose shape at the nodes is a quarter of a sine wave; the end nodes have half a mass.
double barFrequency() {
    const Results results = solve(vibratingBar(5e-6)).results;
    std::vector<double> q;
    for (const Frame& frame : results.frames) {
        double sum = 0.0;
        const std::vector<BoltNodeFrame>& nodes = frame.bolts[0].nodes;
        for (std::size_t j = 1; j < nodes.size(); ++j)
            sum += (j + 1 == nodes.size() ? 0.5 : 1.0) * (nodes[j].position.x() - nodes[j].s) *
                   std::sin(0.5 * std::numbers::pi * static_cast<double>(j) / 60.0);
        q.push_back(sum);
    }
    // the second differences of q = q0·(1 − cos ωt) form a cosine: the sum of its neighbours is 2·cos(ω·Δt) times a
    // value
    double above = 0.0, below = 0.0;
    const auto bend = [&](std::size_t i) { return q[i + 1] - 2.0 * q[i] + q[i - 1]; };
    for (std::size_t i = 2; i + 2 < q.size(); ++i) {
        above += bend(i) * (bend(i + 1) + bend(i - 1));
        below += 2.0 * bend(i) * bend(i);
    }
    return q.size() < 10 ? std::nan("") : std::acos(above / below) / (2.0 * std::numbers::pi * 1e-4);
}

std::vector<CaseResult> barFrequencies() {
    Checks checks("bar vibration in time");
    checks.relative("first frequency, fixed at one end [Hz]", barFrequency(), 630.93, 1e-3);
    return checks.take();
}

}  // namespace

std::vector<Case> schemeCases() {
    return {
        {"scheme's damping", "One strain mode of a free block under every scheme.", schemesDamping},
        {"Rayleigh damping", "The same mode with damping by mass and by stiffness.", rayleigh},
        {"impact", "A stiff block rebounds from springs.", impacts},
        {"sudden load", "A weight suddenly applied to a bar, and one that falls into it.", suddenLoad},
        {"bar vibration in time", "A bar fixed at one end vibrates at its first frequency under Newmark.", barFrequencies},
    };
}

}  // namespace keyblock
