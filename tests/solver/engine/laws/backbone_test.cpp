// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The backbone is held to what it says: its own points in first loading, the
// first slope in unloading, isotropic hardening, and work equal to the area.
#include "solver/engine/laws/backbone.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

namespace keyblock {
namespace {

using Curve = std::vector<std::pair<double, double>>;

const Curve steel{{0.0, 0.0}, {0.002, 400e6}, {0.02, 440e6}, {0.1, 500e6}};
constexpr double modulus = 200e9;
constexpr double loaded = 0.05;  // within the last piece

double onCurve(const Curve& curve, double strain) {
    for (std::size_t i = 1; i < curve.size(); ++i) {
        const auto& [e0, s0] = curve[i - 1];
        const auto& [e1, s1] = curve[i];
        if (strain <= e1) return s0 + (strain - e0) / (e1 - e0) * (s1 - s0);
    }
    return curve.back().second;
}

TEST(Backbone, FirstLoadingFollowsThePieces) {
    const Backbone b = Backbone::of(steel);
    EXPECT_DOUBLE_EQ(b.modulus, modulus);
    EXPECT_DOUBLE_EQ(b.lastStrain, 0.1);
    for (const double strain : {0.0005, 0.002, 0.0021, 0.01, 0.02, 0.05, 0.1}) {
        const BackboneResponse r = respond(b, {}, strain);
        EXPECT_NEAR(r.force, onCurve(steel, strain), 1e-12 * 500e6) << strain;
    }
    EXPECT_NEAR(respond(b, {}, 0.01).tangent, 40e6 / 0.018, 1e-9 * modulus);
}

TEST(Backbone, UnloadsAtTheFirstSlope) {
    const Backbone b = Backbone::of(steel);
    const BackboneState state = respond(b, {}, loaded).state;
    const BackboneResponse r = respond(b, state, loaded - 0.001);
    EXPECT_NEAR(r.force, onCurve(steel, loaded) - 0.001 * modulus, 1e-3);
    EXPECT_DOUBLE_EQ(r.tangent, modulus);
    EXPECT_EQ(r.state, state);
    EXPECT_EQ(r.plasticWork, 0.0);
    EXPECT_NEAR(respond(b, state, loaded).force, onCurve(steel, loaded), 1e-3);  // and back
}

TEST(Backbone, HardensIsotropically) {
    const Backbone b = Backbone::of(steel);
    const double stress = onCurve(steel, loaded);
    const BackboneState state = respond(b, {}, loaded).state;
    const double yieldsAgain = loaded - 2.0 * stress / modulus;
    EXPECT_NEAR(respond(b, state, yieldsAgain).force, -stress, 1e-3);
    const BackboneResponse r = respond(b, state, yieldsAgain - 0.001);
    EXPECT_NEAR(r.force, -stress - 0.001 * 60e6 / 0.08, 1e-3);  // on with the slope of the last piece
    EXPECT_GT(r.state.accumulated, state.accumulated);
    EXPECT_LT(r.state.plastic, state.plastic);
}

TEST(Backbone, CompressionMirrorsTension) {
    const Backbone b = Backbone::of(steel);
    for (const double strain : {0.001, 0.01, 0.07}) {
        const BackboneResponse pull = respond(b, {}, strain), push = respond(b, {}, -strain);
        EXPECT_EQ(push.force, -pull.force);
        EXPECT_EQ(push.tangent, pull.tangent);
        EXPECT_EQ(push.plasticWork, pull.plasticWork);
        EXPECT_EQ(push.state.plastic, -pull.state.plastic);
    }
}

TEST(Backbone, FlatPiecesKeepASmallSlope) {
    const Backbone b = Backbone::of({{0.0, 0.0}, {0.002, 400e6}, {0.1, 400e6}});
    const BackboneResponse r = respond(b, {}, 0.05);
    EXPECT_NEAR(r.tangent, 1e-7 * modulus, 1e-12 * modulus);
    EXPECT_NEAR(r.force, 400e6 + 1e-7 * modulus * 0.048, 1.0);
    EXPECT_GT(respond(b, {}, 0.2).force, respond(b, {}, 0.1).force);  // and past the end
}

TEST(Backbone, PlasticWorkIsTheAreaLessWhatSpringsBack) {
    const Backbone b = Backbone::of(steel);
    double area = 0.0;
    for (const auto& [from, to] : {std::pair{0.0, 0.002}, {0.002, 0.02}, {0.02, loaded}})
        area += 0.5 * (onCurve(steel, from) + onCurve(steel, to)) * (to - from);
    const double stress = onCurve(steel, loaded);
    EXPECT_NEAR(respond(b, {}, loaded).plasticWork, area - 0.5 * stress * stress / modulus, 1e-9 * area);
}

TEST(Backbone, ManyStepsAreOne) {
    const Backbone b = Backbone::of(steel);
    BackboneState state;
    double work = 0.0;
    for (int i = 1; i <= 97; ++i) {
        const BackboneResponse r = respond(b, state, loaded * i / 97.0);
        state = r.state;
        work += r.plasticWork;
    }
    const BackboneResponse once = respond(b, {}, loaded);
    EXPECT_NEAR(state.plastic, once.state.plastic, 1e-15);
    EXPECT_NEAR(work, once.plasticWork, 1e-9 * once.plasticWork);
}

TEST(Backbone, ClosedCycleUsesTheEnclosedArea) {
    const Backbone b = Backbone::of(steel);
    constexpr int steps = 20000;
    BackboneState state;
    double work = 0.0, area = 0.0, before = 0.0, force = 0.0;
    for (int i = 1; i <= steps; ++i) {  // out, through to the other side, and back to no strain
        const double at = 4.0 * i / steps;
        const double strain = loaded * (at < 1.0 ? at : at < 3.0 ? 2.0 - at : at - 4.0);
        const BackboneResponse r = respond(b, state, strain);
        area += 0.5 * (force + r.force) * (strain - before);
        work += r.plasticWork;
        state = r.state;
        force = r.force;
        before = strain;
    }
    EXPECT_NEAR(work + 0.5 * force * force / modulus, area, 1e-6 * area);
}

}  // namespace
}  // namespace keyblock
