// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The numbers that the samples of single blocks, of caught masses and of simple
// bolts say they give, worked out again from closed forms, from energy or by
// integrating one equation; nothing of the engine is used for them.
#include "solver/files/scene/scene_file.h"
#include "solver/run/run.h"
#include "tests/verify/sample.h"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include <cmath>
#include <functional>
#include <numbers>
#include <string>

namespace keyblock {
namespace {

using test::expectedOf;
using test::sample;

constexpr double g = 9.81;  // [m/s²]
constexpr double weightOfCube = 2700.0 * g;  // [N] 1 m³ of the samples' rock

double circle(double diameter) { return 0.25 * std::numbers::pi * diameter * diameter; }

/// Root of a function that is positive before it.
double rootOf(const std::function<double(double)>& f, double low, double high) {
    for (int i = 0; i < 200; ++i) (f(0.5 * (low + high)) > 0.0 ? low : high) = 0.5 * (low + high);
    return low;
}

/// Angle that starts at rest from `angle` under angle'' = rate(angle), after `time` (midpoint rule, 1e5 steps).
double swungTo(double angle, double time, const std::function<double(double)>& rate) {
    const double dt = time * 1e-5;
    double speed = 0.0;
    for (int i = 0; i < 100000; ++i) {
        speed += 0.5 * dt * rate(angle);
        angle += dt * speed;
        speed += 0.5 * dt * rate(angle);
    }
    return angle;
}

TEST(SampleNumbers, SuspendedBlock) {
    const Scene scene = sample("suspended-block");
    const double stretch = 1.0 / 40e6 + 2.0 / (200e9 * 235e-6) + 1.0 / 1e9;  // [m/N] shell, bar, plate
    EXPECT_NEAR(expectedOf(scene, "last joint force"), weightOfCube, 0.1);
    EXPECT_NEAR(expectedOf(scene, "last B.plate_force"), weightOfCube, 0.1);
    EXPECT_NEAR(expectedOf(scene, "last opening"), weightOfCube * stretch, 1e-8);
}

/// Force across the joint for a joint displacement of 1 m: 41 beams of 5 mm, each node on a spring of 1e12 N/m, the
/// beam at the joint soft in shear (theory, "The shank").
double guillotineStiffness() {
    constexpr int beams = 41, middle = 20;
    constexpr double h = 0.005, spring = 1e12;
    const double youngs = 200e9, bend = youngs * std::numbers::pi / 64.0 * std::pow(0.02, 4);
    const double soft = 12.0 * bend * (4.0 / 3.0) / (80e9 * circle(0.02) * h * h);
    Eigen::MatrixXd k = Eigen::MatrixXd::Zero(2 * beams + 2, 2 * beams + 2);
    Eigen::VectorXd load = Eigen::VectorXd::Zero(2 * beams + 2);
    Eigen::Matrix4d joint;
    for (int e = 0; e < beams; ++e) {
        const double b = e == middle ? soft : 0.0;
        Eigen::Matrix4d own;
        own << 12, 6 * h, -12, 6 * h, 6 * h, (4 + b) * h * h, -6 * h, (2 - b) * h * h, -12, -6 * h, 12, -6 * h, 6 * h,
            (2 - b) * h * h, -6 * h, (4 + b) * h * h;
        own *= bend / ((1.0 + b) * h * h * h);
        k.block<4, 4>(2 * e, 2 * e) += own;
        if (e == middle) joint = own;
    }
    for (int n = 0; n <= beams; ++n) {
        k(2 * n, 2 * n) += spring;
        if (n > middle) load[2 * n] = spring;
    }
    const Eigen::VectorXd u = k.fullPivLu().solve(load);
    return std::abs(joint.row(0).dot(u.segment<4>(2 * middle)));
}

TEST(SampleNumbers, Guillotine) {
    const Scene scene = sample("guillotine");
    const double strength = 0.6 * 630e6 * circle(0.02);
    EXPECT_NEAR(expectedOf(scene, "max joint shear"), strength, 0.1);
    EXPECT_NEAR(expectedOf(scene, "first shear-rupture offset"), strength / guillotineStiffness(), 1e-9);
}

/// A mass caught by an anchor of force–slip curve `points` through a bar that stretches by `stretch` [m/N].
struct Catch {
    double mass = 0.0, speed = 0.0;
    Table points;
    double stretch = 0.0;

    double force(double slip) const {
        for (std::size_t i = 1; i < points.size(); ++i) {
            const auto& [a, fa] = points[i - 1];
            const auto& [b, fb] = points[i];
            if (slip <= b) return fa + (fb - fa) * (slip - a) / (b - a);
        }
        return points.back().second;
    }

    double work(double slip) const {
        double sum = 0.0;
        for (std::size_t i = 1; i < points.size() && slip > points[i - 1].first; ++i) {
            const double to = std::min(slip, points[i].first);
            sum += 0.5 * (points[i - 1].second + force(to)) * (to - points[i - 1].first);
        }
        return sum;
    }

    double fall(double slip) const { return slip + force(slip) * stretch; }

    /// Slip at which energy of motion and weight are used up.
    double slip() const {
        const auto left = [this](double x) {
            const double f = force(x);
            return 0.5 * mass * speed * speed + mass * g * fall(x) - work(x) - 0.5 * f * f * stretch;
        };
        return rootOf(left, 0.0, 0.59);
    }
};

TEST(SampleNumbers, MassesCaughtByAnchorsThatYield) {
    const double plate = 1.0 / 1e9, middleOfAnchor = 0.175;
    const std::pair<const char*, Catch> catches[]{
        {"drop-cone-bolt", {1115, 5.425, {{0, 0}, {0.00156, 78e3}, {0.6, 98e3}}, 2.3 / (200e9 * circle(0.0172)) + plate}},
        {"drop-roofex",
         {2000, 3, {{0, 0}, {0.0008, 80e3}, {0.6, 80e3}}, (2.4 - middleOfAnchor) / (200e9 * circle(0.0125)) + plate}},
        {"drop-garford",
         {3000, 2, {{0, 0}, {0.0012, 120e3}, {0.35, 120e3}}, (2.4 - middleOfAnchor) / (200e9 * circle(0.02)) + plate}}};
    for (const auto& [name, caught] : catches) {
        SCOPED_TRACE(name);
        const double slip = caught.slip();
        EXPECT_NEAR(expectedOf(sample(name), "min slip"), -slip, 2e-6);
        EXPECT_NEAR(expectedOf(sample(name), "min mass.uy"), -caught.fall(slip), 2e-6);
    }
}

/// The steel between the inner anchors yields; those anchors, the bar beyond them and the plate are springs.
TEST(SampleNumbers, MassCaughtByADBolt) {
    const double area = circle(0.02), bar = 490e6 / 0.0023 * area, anchor = 84.78e6, spacing = 1.0 / 30.0;
    const double above = anchor + 1.0 / (1.0 / anchor + 10.0 * spacing / bar);
    const double plate = anchor + 1.0 / (1.0 / 1e9 + 6.0 * spacing / bar);
    const double below = anchor + 1.0 / (1.0 / plate + 17.0 * spacing / bar);
    Catch caught{1000, 4, {{0, 0}}, 1.0 / above + 1.0 / below};
    for (const auto& [strain, stress] : Table{{0.0023, 490e6}, {0.021, 500e6}, {0.05, 560e6}, {0.09, 605e6}})
        caught.points.emplace_back(24.0 * spacing * strain, stress * area);
    const Scene scene = sample("drop-d-bolt");
    EXPECT_NEAR(expectedOf(scene, "min mass.uy"), -caught.fall(caught.slip()), 2e-6);
    EXPECT_NEAR(expectedOf(scene, "max joint force"), caught.force(caught.slip()), 1.0);
}

TEST(SampleNumbers, RockingBlockIsUprightAfterAQuarterPeriod) {
    const double critical = std::atan(0.25), radius = std::hypot(0.25, 1.0), tilt = 0.5 * critical;
    const auto rate = [&](double t) { return -0.75 * g / radius * std::sin(critical - t); };
    const Scene scene = sample("rocking-block");
    EXPECT_NEAR(swungTo(tilt, scene.stages.front().duration, rate), 0.0, 1e-4);
    const double cornerBefore = -0.5 * std::cos(tilt) + 2.0 * std::sin(tilt);
    EXPECT_NEAR(expectedOf(scene, "last top.ux"), -0.5 - cornerBefore, 1e-6);
    EXPECT_NEAR(expectedOf(scene, "last foot.uy"), -0.5 * std::sin(tilt), 1e-6);
}

TEST(SampleNumbers, TopplingBlockTurnsAboutItsToe) {
    const double slope = std::numbers::pi / 6.0, radius = 0.5 * std::hypot(0.3, 1.0);
    const double lean = std::asin((0.5 * std::sin(slope) - 0.15 * std::cos(slope)) / radius);
    const auto rate = [&](double t) { return 0.75 * g / radius * std::sin(t); };
    const Scene scene = sample("toppling-block");
    const double turned = swungTo(lean, scene.stages.front().duration, rate);
    EXPECT_NEAR(expectedOf(scene, "last centre.ux"), radius * (std::sin(turned) - std::sin(lean)), 1e-6);
    EXPECT_NEAR(expectedOf(scene, "last centre.uy"), radius * (std::cos(turned) - std::cos(lean)), 1e-6);
}

/// Contact k from the top carries k blocks on two springs of 40·E each; a block shortens under its mean force.
TEST(SampleNumbers, TowerSettlesUnderItsWeight) {
    const double youngs = 60e9;
    double settled = 0.0;
    for (int k = 1; k <= 100; ++k) settled += weightOfCube * (k / (80.0 * youngs) + (k - 0.5) / youngs);
    EXPECT_NEAR(expectedOf(sample("tower-100"), "last top.uy"), -settled, 1e-8);
}

TEST(SampleNumbers, TowersFootCarriesAllOfIt) {
    const Results results = runInMemory(sample("tower-100"));
    double foot = 0.0, deepest = 0.0;
    for (const ContactFrame& contact : results.frames.back().contacts) {
        if (std::min(contact.blockA, contact.blockB) > 0) continue;
        foot += contact.normalForce;
        deepest = std::max(deepest, contact.penetration);
    }
    EXPECT_NEAR(foot / (100.0 * weightOfCube), 1.0, 1e-4);
    EXPECT_NEAR(deepest / (100.0 * weightOfCube / (80.0 * 60e9)), 1.0, 1e-3);
}

/// Shi's scheme on the reduced mass of two equal blocks and the two springs between them, step by step.
TEST(SampleNumbers, BlocksPartAsTheSchemeSays) {
    const Scene scene = sample("impact");
    const Stage& stage = scene.stages.front();
    const double springs = 2.0 * 0.001 * 60e9, reduced = 0.5 * 2700.0, dt = *stage.timeStep;
    const double eta = dt * std::sqrt(springs / reduced);
    EXPECT_NEAR(eta, 0.1, 1e-6);
    double gap = 0.0, speed = -1.0;
    const long steps = std::lround(stage.duration / dt);
    for (long i = 0; i < steps; ++i) {
        double move = dt * speed;
        if (gap + move < 0.0) move = (move - 0.5 * eta * eta * gap) / (1.0 + 0.5 * eta * eta);
        speed = 2.0 * move / dt - speed;
        gap += move;
    }
    EXPECT_NEAR(speed, 0.9257, 1e-4);
    EXPECT_NEAR(expectedOf(scene, "last striker.ux"), 0.5 * (stage.duration - gap), 1e-6);
    EXPECT_NEAR(expectedOf(scene, "last struck.ux"), 0.5 * (stage.duration + gap), 1e-6);
}

TEST(SampleNumbers, FrictionBoltPulledOut) {
    const Scene scene = sample("pull-out-gap");
    const double friction = 54e3, untilItSlides = friction / 75e6;
    EXPECT_NEAR(expectedOf(scene, "max pull force"), friction * (0.8 - untilItSlides + 1.0), 0.1);
    EXPECT_NEAR(expectedOf(scene, "first pulled-out pull force"), friction * 1.0, 0.1);
    EXPECT_EQ(expectedOf(scene, "last pull force"), 0.0);
}

}  // namespace
}  // namespace keyblock
