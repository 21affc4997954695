// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The schemes of time integration through the whole run, held to their own
// formulas: one mode, free fall, driven blocks, damping, time itself.
#include "solver/engine/contact/search.h"
#include "solver/engine/setup/make_model.h"
#include "solver/engine/stage/dynamics.h"
#include "solver/run/run.h"
#include "solver/verify/mode.h"
#include "solver/verify/scenes.h"
#include "tests/solver/run/small_stages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>

namespace keyblock {
namespace {

const std::vector<Integration> allSchemes{Integration::Shi, Integration::BackwardEuler, Integration::Newmark,
                                          Integration::GeneralizedAlpha};

Stage dynamic(Integration scheme, double duration, double timeStep) {
    Stage stage = test::dynamic(duration, timeStep);
    stage.integration = scheme;
    return stage;
}

/// Trace and determinant of the step of a mode, from four successive values.
std::pair<double, double> traceAndDeterminant(const std::vector<double>& x) {
    const double whole = x[1] * x[1] - x[0] * x[2];
    return {(x[1] * x[2] - x[0] * x[3]) / whole, (x[2] * x[2] - x[1] * x[3]) / whole};
}

TEST(Schemes, AModeFollowsTheFormulas) {
    for (const Integration scheme : allSchemes)
        for (const double rho : {0.0, 0.6, 1.0})
            for (const double eta : {0.01, 0.1, 1.0, 3.0, 10.0, 100.0})
                for (const double damped : {0.0, 0.2}) {
                    const ModeSetting setting{scheme, rho, eta, damped, 0.5 * damped, 12};
                    const std::vector<double> run = modeSeries(setting), closed = closedSeries(setting);
                    ASSERT_EQ(run.size(), closed.size());
                    for (std::size_t i = 0; i < run.size(); ++i)
                        EXPECT_NEAR(run[i], closed[i], 1e-8) << static_cast<int>(scheme) << " " << eta << " " << i;
                }
}

/// Amplitude kept in each step and angle that a step turns the mode by.
TEST(Schemes, DampingAndFrequencyOfAMode) {
    for (const double eta : {0.01, 0.1, 1.0, 3.0}) {
        const auto [shiTrace, shiKept] = traceAndDeterminant(modeSeries({.scheme = Integration::Shi, .eta = eta}));
        EXPECT_NEAR(shiKept, 1.0 / (1.0 + 0.5 * eta * eta), 1e-6);
        EXPECT_NEAR(shiTrace, (4.0 - eta * eta) / (2.0 + eta * eta), 1e-6);
        const auto [eulerTrace, eulerKept] =
            traceAndDeterminant(modeSeries({.scheme = Integration::BackwardEuler, .eta = eta}));
        EXPECT_NEAR(eulerKept, 1.0 / (1.0 + eta * eta), 1e-6);
        EXPECT_NEAR(std::acos(0.5 * eulerTrace / std::sqrt(eulerKept)), std::atan(eta), 1e-4);
        const auto [trace, kept] = traceAndDeterminant(modeSeries({.scheme = Integration::Newmark, .eta = eta}));
        EXPECT_NEAR(kept, 1.0, 1e-6);
        EXPECT_NEAR(std::acos(0.5 * trace), 2.0 * std::atan(0.5 * eta), 1e-4);
    }
}

TEST(Schemes, ModesMuchStifferThanTheStep) {
    EXPECT_NEAR(closedRadius({.scheme = Integration::Shi, .eta = 1e4}), 1.0, 1e-6);  // the root at −1
    const std::vector<double> ringing = modeSeries({.scheme = Integration::Shi, .eta = 100.0});
    EXPECT_NEAR(ringing[11] / ringing[10], -1.0, 1e-3);
    EXPECT_LT(closedRadius({.scheme = Integration::BackwardEuler, .eta = 1e4}), 2e-4);
    for (const double rho : {0.0, 0.3, 0.8, 1.0})
        EXPECT_NEAR(closedRadius({.scheme = Integration::GeneralizedAlpha, .rhoInf = rho, .eta = 1e6}), rho, 1e-2);
    for (const double rho : {0.3, 0.8}) {
        const ModeSetting setting{.scheme = Integration::GeneralizedAlpha, .rhoInf = rho, .eta = 1e3};
        EXPECT_NEAR(spectralRadius(modeSeries(setting), 3), closedRadius(setting), 1e-3);
        EXPECT_NEAR(spectralRadius(modeSeries(setting), 3), rho, 2e-2);
    }
}

/// Without loss of its own the scheme with ρ∞ = 1 is Newmark's, as long as forces are linear.
TEST(Schemes, GeneralizedAlphaAtOneIsNewmark) {
    const std::vector<double> a = modeSeries({.scheme = Integration::GeneralizedAlpha, .rhoInf = 1.0, .eta = 0.7});
    const std::vector<double> n = modeSeries({.scheme = Integration::Newmark, .eta = 0.7});
    for (std::size_t i = 0; i < n.size(); ++i) EXPECT_NEAR(a[i], n[i], 1e-9);
}

Scene lone() {
    Scene scene = emptyScene(10e9, 0.2, 30.0);
    scene.blocks = {boxBlock("block", {0, 0}, {1, 1})};
    return scene;
}

TEST(Schemes, FreeFallIsExact) {
    for (const Integration scheme : {Integration::Shi, Integration::Newmark, Integration::GeneralizedAlpha}) {
        Scene scene = lone();
        scene.analysis.gravity = {0.0, -gravity};
        scene.stages = {dynamic(scheme, 1.0, 0.01)};
        const Results results = runInMemory(scene);
        EXPECT_NEAR(results.frames.back().blocks[0].displacement.y(), -0.5 * gravity, 1e-10);
        EXPECT_NEAR(results.frames.back().blocks[0].velocity.y(), -gravity, 1e-10);
        EXPECT_LT(std::abs(results.stages[0].health.balanceError), 1e-10);
    }
}

/// A block that is driven at a constant rate has that rate from the first moment to the last; the drive pays for it.
TEST(Schemes, ADrivenBlockDoesNotRing) {
    for (const Integration scheme : allSchemes) {
        Scene scene = lone();
        Motion motion;
        motion.blockAt = {0.5, 0.4};
        motion.table = {{0.0, 0.0}, {0.05, 0.1}, {0.1, 0.1}};
        scene.stages = {dynamic(scheme, 0.1, 1e-3)};
        scene.stages[0].motions = {motion};
        scene.output.every = 1e-3;
        const Results results = runInMemory(scene);
        for (const Frame& frame : results.frames) {
            const double rate = frame.time < 0.05 + 1e-9 ? 2.0 : 0.0;
            EXPECT_NEAR(frame.blocks[0].velocity.x(), rate, 1e-9) << frame.time;
            EXPECT_NEAR(frame.energy.kinetic, 0.5 * 2700.0 * rate * rate, 1e-5) << frame.time;
            EXPECT_NEAR(frame.energy.external, frame.energy.kinetic, 1e-5) << frame.time;
            EXPECT_NEAR(frame.energy.damped, 0.0, 1e-5) << frame.time;
        }
    }
}

/// What the damping of a mode takes is what the mode loses.
TEST(Schemes, DampingIsBooked) {
    for (const Integration scheme : allSchemes) {
        Scene scene = lone();
        scene.materials[0].second = {2700.0, 60e6, 0.0};
        scene.analysis.rhoInf = 1.0;
        scene.blocks[0].initialStress = {100.0, 0.0, 0.0};
        const double frequency = std::sqrt(12.0 * 60e6 / 2700.0);
        scene.analysis.damping = {0.1 * frequency, 0.1 / frequency};  // a tenth of critical
        scene.stages = {dynamic(scheme, 10.0 / frequency, 0.02 / frequency)};
        const Results results = runInMemory(scene);
        const double given = 0.5 * 100.0 * 100.0 / 60e6;
        const Energy& energy = results.frames.back().energy;
        EXPECT_LT(energy.kinetic + energy.strain, 0.2 * given);
        EXPECT_NEAR(energy.damped, given - energy.kinetic - energy.strain, 1e-6 * given) << static_cast<int>(scheme);
        EXPECT_LT(std::abs(results.stages[0].health.balanceError), 1e-6);
    }
}

/// A block bounces on springs under its weight and comes back as high as it was, again and again.
TEST(Schemes, NewmarkKeepsTheEnergyOfABounce) {
    for (const double step : {1e-4, 1e-3, 7e-3}) {
        Scene scene = emptyScene(6e13, 0.0, 0.0);
        scene.analysis.penaltyRatio = 1e-5;
        scene.analysis.gravity = {0.0, -gravity};
        scene.blocks = {boxBlock("floor", {-1, -1}, {2, 0}), boxBlock("block", {0, 0.05}, {1, 1.05})};
        Support support;
        support.blockAt = Point(0.5, -0.5);
        scene.supports = {support};
        scene.stages = {dynamic(Integration::Newmark, 1.0, step)};
        scene.output.every = step;
        const Results results = runInMemory(scene);
        const double weight = 2700.0 * gravity;
        double highest = -1.0;
        for (const Frame& frame : results.frames) {
            const Energy& e = frame.energy;
            EXPECT_NEAR(e.kinetic + e.strain + e.contact, e.external, 1e-9 * weight * 0.05) << step << " " << frame.time;
            EXPECT_NEAR(e.damped, 0.0, 1e-9 * weight * 0.05);
            if (frame.time > 0.5) highest = std::max(highest, frame.blocks[1].displacement.y());
        }
        EXPECT_GT(highest, -0.03) << step;
        EXPECT_LE(highest, 1e-9) << step;
    }
}

/// Knocks keep Coulomb's ratio of impulses: under a mean push friction takes its mean, too.
TEST(Schemes, ASlantedKnockObeysCoulomb) {
    for (const Integration scheme : allSchemes) {
        Scene scene = emptyScene(6e13, 0.0, 5.0);
        scene.analysis.penaltyRatio = 1e-5;
        scene.blocks = {boxBlock("floor", {-9, -1}, {9, 0}), boxBlock("block", {0, 0}, {8, 0.1})};
        Support support;
        support.blockAt = Point(0.5, -0.5);
        scene.supports = {support};
        scene.stages = {dynamic(scheme, 0.05, 1e-5)};
        InitialVelocity initial;
        initial.blockAt = {4.0, 0.05};
        initial.velocity = {3.0, -1.0};
        scene.stages[0].initialVelocities = {initial};
        const Results results = runInMemory(scene);
        const BlockState& block = results.frames.back().blocks[1];
        const double push = 1.0 + block.velocity.y(), drag = 3.0 - block.velocity.x();
        EXPECT_GT(block.velocity.y(), 0.5);
        EXPECT_NEAR(drag, std::tan(5.0 * std::acos(-1.0) / 180.0) * push, 0.02 * drag) << static_cast<int>(scheme);
    }
}

/// A block that flies off breaks the plate of a bar that held it back by 3.7 m/s²: from then on it has the speed that it
/// had. An acceleration that remembered the plate would take another 5e-6 m/s.
TEST(Schemes, GeneralizedAlphaForgetsWhatLetGo) {
    Scene scene = twoBlocks(60e9, 1.0, 2.0);
    scene.analysis.integration = Integration::GeneralizedAlpha;
    BoltType type = linearType(std::acos(-1.0) * 1e-4, 200e9);
    type.density = 1.0;
    type.anchors = {anchorAt(0.0, AnchorLaw::Elastic, 1e8)};
    type.plate.normalStiffness = 1e7;
    type.plate.normalStrength = 10e3;
    addBolt(scene, type, 0.1, 2.0, 4, PlateKind::Spring);
    Stage stage;
    stage.name = "fly";
    stage.kind = StageKind::Dynamic;
    stage.duration = 0.02;
    stage.timeStep = 1e-4;
    InitialVelocity velocity;
    velocity.blockAt = Point(1.5, 0.5);
    velocity.velocity = {1.0, 0.0};
    stage.initialVelocities = {velocity};
    scene.stages = {stage};
    scene.output.frames = 50;
    const Results results = runInMemory(scene);
    const auto lost = std::find_if(results.events.begin(), results.events.end(),
                                   [](const Event& event) { return event.kind == EventKind::PlateLoss; });
    ASSERT_NE(lost, results.events.end());
    const double last = results.frames.back().blocks[1].velocity.x();
    EXPECT_LT(last, 0.998);
    for (const Frame& frame : results.frames) {
        if (frame.time <= lost->time) continue;
        EXPECT_NEAR(frame.blocks[1].velocity.x(), last, 1e-6) << frame.time;
    }
}

/// Ten thousand steps of a length that no binary number is: the time is theirs exactly.
TEST(Schemes, TimeDoesNotDrift) {
    const Scene scene = lone();
    const Model model = makeModel(scene);
    State state = makeState(model);
    Engine engine(model);
    const Loads loads;
    DynamicStage stage(engine, loads, [](double) { return LoadPoint{}; }, {Inertia::Shi, 1e-6});
    DynamicPace pace;
    struct Deaf : StepObserver {
        void beforeEvent(const State&, double) override {}
        long event(Event, const State&, double) override { return 0; }
        void afterEvent(const State&, double) override {}
    } observer;
    double time = 0.0;
    for (int i = 1; i <= 10000; ++i) {
        ASSERT_EQ(stage.step(state, time, 1.0, pace, observer).ending, Ending::Done);
        ASSERT_NEAR(time, i * 1e-6, 2.3e-16 * time);
    }
}

}  // namespace
}  // namespace keyblock
