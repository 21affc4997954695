// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Point supports and point loads of blocks that turn: pendulums against closed
// forms under every scheme, and what a force does along the path of its point.
#include "solver/engine/setup/make_model.h"
#include "solver/engine/stage/dynamics.h"
#include "solver/engine/stage/energy.h"
#include "solver/engine/support.h"
#include "solver/verify/scenes.h"
#include "tests/solver/engine/silent_observer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace keyblock {
namespace {

constexpr double width = 0.5, height = 1.0;  // of the pendulum [m]
constexpr double arm = 0.4;  // from its support to its centroid [m]
constexpr double inertia = (width * width + height * height) / 12.0 + arm * arm;  // about the support, over mass [m²]

constexpr double radians(double degrees) { return degrees * std::numbers::pi / 180.0; }

Point turned(const Point& p, double angle) {
    return {std::cos(angle) * p.x() - std::sin(angle) * p.y(), std::sin(angle) * p.x() + std::cos(angle) * p.y()};
}

/// A block on a support 0.1 m below the middle of its upper edge, turned by `angle` [rad] from hanging.
Scene pendulum(double angle) {
    Scene scene = emptyScene(10e9, 0.25, 30.0);
    scene.analysis.gravity = {0.0, -gravity};
    scene.blocks = {boxBlock("pendulum", {-0.5 * width, -arm - 0.5 * height}, {0.5 * width, 0.5 * height - arm})};
    for (Point& p : scene.blocks[0].points) p = turned(p, angle);
    Support support;
    support.point = Point(0.0, 0.0);
    support.fix = Fix::XY;
    scene.supports = {support};
    return scene;
}

/// A model that is stepped under constant loads.
class Motion {
public:
    Motion(const Scene& scene, Inertia scheme, double dt, const Loads& loads = {}, const LoadPoint& at = {})
        : model(makeModel(scene)), state(makeState(model)), engine_(model), loads_(loads), at_(at),
          stage_(engine_, loads_, [this](double) { return at_; }, {scheme, dt, 0.8}) {
        at_.gravity = 1.0;
        startEnergy = state.startEnergy = accountedEnergy(model, state);
        stage_.begin(state);
    }
    Motion(const Motion&) = delete;
    Motion& operator=(const Motion&) = delete;

    bool step() { return stage_.step(state, time, 1e9, pace_, silent_).ending == Ending::Done; }

    /// What the energy account leaves over [J].
    double leftOver() const { return accountedEnergy(model, state) - startEnergy; }

    Model model;
    State state;
    double time = 0.0, startEnergy = 0.0;

private:
    Engine engine_;
    Loads loads_;
    LoadPoint at_;
    DynamicStage stage_;
    DynamicPace pace_;
    test::SilentObserver silent_;
};

struct Swing {
    std::vector<double> amplitudes;  // of the half swings between passes through the lowest point [rad]
    double period = 0.0;  // mean [s]
    double leftOver = 0.0;  // most that the energy account left over, over the energy of the swing
    double damped = 0.0;  // over the same
    double support = 0.0;  // farthest that the supported point was from its place [m]
    double weight = 0.0;  // [N]
};

Swing swing(double amplitude, Inertia scheme, double dt, int periods) {
    Motion motion(pendulum(amplitude), scheme, dt);
    Swing result;
    result.weight = motion.model.blocks[0].mass * gravity;
    const double energy = result.weight * arm * (1.0 - std::cos(amplitude));
    double angle = amplitude, farthest = 0.0, firstPass = 0.0, lastPass = 0.0;
    int passes = 0;
    const PointSupport& support = motion.model.supports[0];
    while (passes <= 2 * periods) {
        const double before = motion.time, angleBefore = angle;
        if (!motion.step()) {
            ADD_FAILURE() << "a step failed at " << motion.time << " s";
            break;
        }
        angle = amplitude + motion.state.blocks[0].angle;
        farthest = std::max(farthest, std::abs(angle));
        const Point moved = materialPoint(motion.state.blocks[0], support.place) - startOf(motion.model, support);
        result.support = std::max(result.support, moved.norm());
        if (angle * angleBefore > 0.0) continue;
        lastPass = before + (motion.time - before) * angleBefore / (angleBefore - angle);
        if (passes++ == 0) firstPass = lastPass;
        else result.amplitudes.push_back(farthest);
        farthest = 0.0;
        result.leftOver = std::max(result.leftOver, std::abs(motion.leftOver()) / energy);
    }
    result.period = 2.0 * (lastPass - firstPass) / (passes - 1);
    result.damped = motion.state.energy.damped / energy;
    return result;
}

/// Period of a pendulum by the complete elliptic integral, as an arithmetic-geometric mean [s].
double exactPeriod(double amplitude) {
    double a = 1.0, b = std::cos(0.5 * amplitude);
    for (int i = 0; i < 6; ++i) {
        const double mean = 0.5 * (a + b);
        b = std::sqrt(a * b);
        a = mean;
    }
    return 2.0 * std::numbers::pi * std::sqrt(inertia / (gravity * arm)) / a;
}

struct Case {
    Inertia scheme;
    const char* name;
    double mostChange;  // of the amplitude over 20 periods
};
const std::vector<Case> keeping{{Inertia::Shi, "shi", 1e-3},
                                {Inertia::Newmark, "newmark", 1e-3},
                                {Inertia::GeneralizedAlpha, "generalized-alpha", 5e-3}};

TEST(PointSupport, PendulumKeepsItsAmplitudeOverTwentyPeriods) {
    for (const Case& c : keeping)
        for (const double degrees : {10.0, 60.0}) {
            const Swing s = swing(radians(degrees), c.scheme, 1e-3, 20);
            ASSERT_FALSE(s.amplitudes.empty());
            const auto [least, most] = std::minmax_element(s.amplitudes.begin(), s.amplitudes.end());
            EXPECT_NEAR(*least / radians(degrees), 1.0, c.mostChange) << c.name << " " << degrees;
            EXPECT_NEAR(*most / radians(degrees), 1.0, c.mostChange) << c.name << " " << degrees;
            EXPECT_LT(s.leftOver, 0.01) << c.name << " " << degrees;
            EXPECT_LT(std::abs(s.damped), 0.01) << c.name << " " << degrees;
        }
}

TEST(PointSupport, PendulumHasThePeriodOfTheEllipticIntegral) {
    for (const Case& c : keeping)
        for (const double degrees : {1.0, 60.0, 150.0}) {
            const double exact = exactPeriod(radians(degrees));
            const double period = swing(radians(degrees), c.scheme, 1e-3, 2).period;
            EXPECT_NEAR(period / exact, 1.0, 1e-4) << c.name << " " << degrees;
        }
    const double small = 2.0 * std::numbers::pi * std::sqrt(inertia / (gravity * arm));
    EXPECT_NEAR(exactPeriod(radians(1.0)) / small, 1.0, 2e-5);
}

TEST(PointSupport, PendulumUnderBackwardEulerLosesWhatIsAccountedForAsDamped) {
    for (const double degrees : {10.0, 60.0}) {
        const Swing s = swing(radians(degrees), Inertia::BackwardEuler, 1e-3, 20);
        double before = radians(degrees);
        for (const double amplitude : s.amplitudes) {
            EXPECT_LE(amplitude, before);
            before = amplitude;
        }
        EXPECT_LT(s.leftOver, 0.01);
        const double left = (1.0 - std::cos(before)) / (1.0 - std::cos(radians(degrees)));
        EXPECT_NEAR(s.damped, 1.0 - left, 0.01);  // the last quarter swing loses a little more
    }
}

TEST(PointSupport, LongStepsKeepTheAmplitude) {
    for (const Case& c : keeping) {
        const Swing s = swing(radians(100.0), c.scheme, 4e-3, 20);
        ASSERT_FALSE(s.amplitudes.empty());
        EXPECT_NEAR(s.amplitudes.back() / radians(100.0), 1.0, c.mostChange) << c.name;
        EXPECT_LT(s.leftOver, 0.01) << c.name;
    }
}

TEST(PointSupport, HangingBlockSinksByItsWeightOverTheSpring) {
    Motion motion(pendulum(0.0), Inertia::BackwardEuler, 1e-3);
    for (int step = 0; step < 200; ++step) ASSERT_TRUE(motion.step());
    const PointSupport& support = motion.model.supports[0];
    const Point moved = materialPoint(motion.state.blocks[0], support.place) - startOf(motion.model, support);
    const double spring = motion.model.numerics.penaltyRatio * 10e9;  // 1 m thick
    EXPECT_NEAR(-moved.y() * spring / (motion.model.blocks[0].mass * gravity), 1.0, 1e-6);
}

/// The pull of a swing from 60° is at most mg·(cos θ + 2·arm²/inertia·(cos θ − ½)). A force that is applied at once takes
/// the spring twice as far.
TEST(PointSupport, SupportedPointMovesByItsForceOverTheSpring) {
    for (const Case& c : keeping) {
        const Swing s = swing(radians(60.0), c.scheme, 1e-3, 2);
        const double spring = 40.0 * 10e9, pull = s.weight * (1.0 + arm * arm / inertia);
        EXPECT_LT(s.support, 2.0 * pull / spring) << c.name;
    }
}

TEST(PointMoves, AreExactForTheDisplacementThatIsExpected) {
    const Model model = makeModel(pendulum(0.3));
    State state = makeState(model);
    Vector6 first, path;
    first << 0.1, -0.2, 0.7, 1e-3, -2e-3, 3e-3;
    path << 0.05, 0.02, -0.9, 2e-3, 1e-3, -1e-3;
    moveBlock(model.blocks[0], state.blocks[0], first);
    State moved = state;
    moveBlock(model.blocks[0], moved.blocks[0], path);
    const Eigen::VectorXd all = path;
    const Point place(0.2, 0.3);
    const Point exact = materialPoint(moved.blocks[0], place) - materialPoint(state.blocks[0], place);
    for (const double share : {0.5, 5.0 / 9.0, 1.0}) {
        const PointMove move = pointMove(model, state, 0, place, {1e-3, share, &all});
        EXPECT_LT((move.t * path + move.beyond - exact).norm(), 1e-15) << share;
        EXPECT_EQ(move.beyond.isZero(0.0), share == 0.5) << share;
    }
    const PointMove still = pointMove(model, state, 0, place, {});
    EXPECT_EQ(still.t, displacementMatrix(state.blocks[0], materialPoint(state.blocks[0], place)));
    EXPECT_TRUE(still.beyond.isZero(0.0));
}

/// A force of constant direction on a point has the potential −F·x: its work is F times the way of its point, and the
/// block, without gravity, has just that as kinetic energy.
TEST(PointLoad, DoesTheWorkOfItsPointOnATurningBlock) {
    Scene scene = pendulum(0.0);
    scene.analysis.gravity = {0.0, 0.0};
    scene.supports.clear();
    Loads loads;
    loads.forces = {{0, {0.0, 0.5}, {5e3, 0.0}}};
    LoadPoint at;
    at.forces = {1.0};
    for (const Case& c : keeping) {
        Motion motion(scene, c.scheme, 1e-3, loads, at);
        const Point start = materialPoint(motion.state.blocks[0], loads.forces[0].place);
        for (int step = 0; step < 3000; ++step) ASSERT_TRUE(motion.step());
        const Point way = materialPoint(motion.state.blocks[0], loads.forces[0].place) - start;
        const Energy energy = energyOf(motion.model, motion.state);
        const double work = loads.forces[0].force.dot(way);
        EXPECT_GT(std::abs(motion.state.blocks[0].angle), 1.0) << c.name;
        EXPECT_NEAR(energy.external / work, 1.0, 1e-4) << c.name;
        EXPECT_NEAR(energy.kinetic / work, 1.0, 1e-3) << c.name;
        EXPECT_LT(std::abs(motion.leftOver()) / work, 1e-6) << c.name;
    }
}

/// A block on a support, without gravity, is a pendulum in the field of a force of constant direction on another point.
TEST(PointLoad, DrivesAPendulumOfItsOwnPeriod) {
    Scene scene = pendulum(radians(60.0));
    scene.analysis.gravity = {0.0, 0.0};
    const double force = 2e4, lever = 0.9;  // from the support to the lower edge [m]
    Loads loads;
    loads.forces = {{0, turned({0.0, -0.5 * height}, radians(60.0)), {0.0, -force}}};
    LoadPoint at;
    at.forces = {1.0};
    for (const Case& c : keeping) {
        Motion motion(scene, c.scheme, 1e-3, loads, at);
        const double mass = motion.model.blocks[0].mass;
        const double period = exactPeriod(radians(60.0)) * std::sqrt(mass * gravity * arm / (force * lever));
        double angle = radians(60.0), farthest = 0.0, lastPass = 0.0, firstPass = 0.0;
        int passes = 0;
        while (passes < 21) {
            const double before = motion.time, angleBefore = angle;
            ASSERT_TRUE(motion.step()) << c.name;
            angle = radians(60.0) + motion.state.blocks[0].angle;
            farthest = std::max(farthest, std::abs(angle));
            if (angle * angleBefore > 0.0) continue;
            lastPass = before + (motion.time - before) * angleBefore / (angleBefore - angle);
            if (passes++ == 0) firstPass = lastPass;
            if (passes < 21) farthest = 0.0;
        }
        EXPECT_NEAR(farthest / radians(60.0), 1.0, c.mostChange) << c.name;
        EXPECT_NEAR((lastPass - firstPass) / (10.0 * period), 1.0, 1e-4) << c.name;
    }
}

}  // namespace
}  // namespace keyblock
