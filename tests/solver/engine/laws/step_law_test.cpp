// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The force that a law gives to a whole step, held to sums over many small
// pieces of the way: the mean is the mean, nothing is lost under it, and what
// the other rules lose is never less than nothing.
#include "solver/engine/laws/step_law.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace keyblock {
namespace {

const Backbone steelLaw = Backbone::of({{0.0, 0.0}, {1.0, 10.0}, {3.0, 12.0}, {10.0, 15.0}});

Law law(LawKind kind) {
    Law l;
    l.kind = kind;
    l.stiffness = 10.0;
    l.offset = 0.25;
    l.limit = 4.0;
    l.curve = &steelLaw;
    l.state = {0.4, 0.6};
    l.share = 3.0;
    return l;
}

const std::vector<LawKind> kinds{LawKind::Linear, LawKind::Gap, LawKind::Capped, LawKind::Constant, LawKind::Curve};
constexpr StepRule end{ForceRule::End, 1.0}, average{ForceRule::Average, 1.0}, blend{ForceRule::Blend, 0.6};

/// Starts that the law can have been left at.
std::vector<double> starts(LawKind kind) {
    if (kind == LawKind::Capped) return {-0.15, 0.0, 0.25, 0.5, 0.65};  // within its limit
    if (kind == LawKind::Curve) return {-0.6, 0.0, 0.4, 1.0, 1.4};  // within yield
    return {-2.0, -0.3, 0.25, 0.3, 2.0};
}

double meanOfPieces(const Law& l, double from, double to) {
    const int pieces = 20000;
    double sum = 0.0;
    for (int i = 0; i < pieces; ++i) sum += respond(l, from + (i + 0.5) / pieces * (to - from)).force;
    return sum / pieces;
}

TEST(StepLaw, TheAverageIsTheMeanAlongTheWay) {
    for (const LawKind kind : kinds)
        for (const double from : starts(kind))
            for (const double to : {-3.0, -0.2, 0.24, 0.26, 0.7, 5.0})
                EXPECT_NEAR(averageResponse(law(kind), from, to).force, meanOfPieces(law(kind), from, to), 1e-6)
                    << static_cast<int>(kind) << " " << from << " " << to;
}

TEST(StepLaw, EveryRuleRisesWithTheEnd) {
    for (const StepRule& rule : {end, average, blend})
        for (const LawKind kind : kinds)
            for (const double from : starts(kind)) {
                double before = -1e9;
                for (double to = -3.0; to < 5.0; to += 0.013) {
                    const LawResponse r = respondOverStep(law(kind), from, to, rule);
                    EXPECT_GE(r.force, before - 1e-12);
                    EXPECT_GE(r.tangent, 0.0);
                    const double next = respondOverStep(law(kind), from, to + 1e-7, rule).force;
                    const double last = respondOverStep(law(kind), from, to - 1e-7, rule).force;
                    const double forward = (next - r.force) / 1e-7, backward = (r.force - last) / 1e-7;
                    EXPECT_LE(r.tangent, std::max(forward, backward) + 1e-5);
                    EXPECT_GE(r.tangent, std::min(forward, backward) - 1e-5);
                    before = r.force;
                }
            }
}

/// A difference of potentials over a short way would lose its digits; the mean of the pieces keeps them.
TEST(StepLaw, TheAverageKeepsItsDigitsOnShortWays) {
    for (const double step : {1e-6, 1e-10, 1e-14}) {
        EXPECT_NEAR(averageResponse(law(LawKind::Capped), 0.65 - step, 0.65 + step).force, 4.0, 20.0 * step + 1e-14);
        EXPECT_NEAR(averageResponse(law(LawKind::Gap), 0.25 - step, 0.25 + 3.0 * step).force, -1.25 * step, 1e-14);
        EXPECT_NEAR(averageResponse(law(LawKind::Curve), 1.4, 1.4 + step).force, respond(law(LawKind::Curve), 1.4).force,
                    20.0 * step + 1e-13);
    }
}

TEST(StepLaw, TheAverageLosesNothing) {
    for (const LawKind kind : kinds)
        for (const double from : starts(kind))
            for (const double to : {-3.0, -0.2, 0.3, 5.0})
                EXPECT_NEAR(lawLoss(law(kind), from, to, average), 0.0, 1e-11) << static_cast<int>(kind);
}

TEST(StepLaw, TheForceAtTheEndNeverGives) {
    for (const LawKind kind : kinds)
        for (const double from : starts(kind))
            for (double to = -3.0; to < 5.0; to += 0.1)
                for (const StepRule& rule : {end, blend}) EXPECT_GE(lawLoss(law(kind), from, to, rule), -1e-12);
    const Law spring = law(LawKind::Linear);
    EXPECT_NEAR(lawLoss(spring, 0.1, 0.7, end), 3.0 * 0.5 * 10.0 * 0.36, 1e-12);
    EXPECT_NEAR(lawLoss(spring, 0.1, 0.7, blend), 3.0 * 0.1 * 10.0 * 0.36, 1e-12);
}

/// A limit that fell since the last step: what the spring then holds less is lost, not gained.
TEST(StepLaw, AFallenLimitIsALoss) {
    Law friction = law(LawKind::Capped);
    const double before = friction.offset + 0.35;  // carries 3.5
    friction.limit = 1.0;
    for (const StepRule& rule : {end, average, blend})
        for (const double to : {before - 1.0, before, before + 1.0}) EXPECT_GE(lawLoss(friction, before, to, rule), 0.0);
    EXPECT_NEAR(lawLoss(friction, before, before, average), 3.0 * 0.5 * 2.5 * 2.5 / 10.0, 1e-12);
}

TEST(StepLaw, DampersActAtTheEndUnderEveryRule) {
    for (const StepRule& rule : {end, average, blend}) {
        const Law damper = law(LawKind::Viscous);
        EXPECT_DOUBLE_EQ(respondOverStep(damper, 0.0, 0.75, rule).force, 5.0);
        EXPECT_NEAR(lawLoss(damper, 0.25, 0.75, rule), 3.0 * 5.0 * 0.5, 1e-12);
    }
}

/// Friction on a way along which its limit goes evenly from one value to another, in many small returns.
struct Way {
    double used = 0.0, force = 0.0;
};
Way slidInPieces(Law l, double from, double to, double startLimit) {
    const int pieces = 20000;
    const double endLimit = l.limit;
    Way way;
    for (int i = 1; i <= pieces; ++i) {
        const double share = static_cast<double>(i) / pieces;
        l.limit = startLimit + share * (endLimit - startLimit);
        const double at = from + share * (to - from);
        way.force = respond(l, at).force;
        const double offset = at - way.force / l.stiffness;
        way.used += way.force * (offset - l.offset);
        l.offset = offset;
    }
    return way;
}

PathStart startAt(const Law& l, double strain, double limit) { return {strain, carriedForce(l, strain), limit}; }

TEST(StepLaw, PathsOfFrictionFollowTheLimit) {
    const Law l = law(LawKind::Capped);
    const double from = 0.25;
    for (const double startLimit : {0.0, 2.0, 4.0, 6.0})
        for (const double to : {0.3, 1.0, 4.0, -1.0}) {
            const Way way = slidInPieces(l, from, to, startLimit);
            const PathWork path = pathWork(l, startAt(l, from, startLimit), to);
            const double moved = to - way.force / l.stiffness - l.offset;
            EXPECT_NEAR(path.slipForce * moved, way.used, 1e-3 * (1.0 + way.used)) << startLimit << " " << to;
            const double stored = 0.5 * way.force * way.force / l.stiffness;
            EXPECT_NEAR(path.surplus, l.share * (0.5 * way.force * (to - from) - stored - path.slipForce * moved), 1e-9);
        }
    EXPECT_NEAR(pathWork(l, startAt(l, from, 0.0), 3.0).surplus, 0.0, 1e-12);  // force in proportion
}

TEST(StepLaw, AGapThatClosesLeavesASurplus) {
    const Law gap = law(LawKind::Gap);  // closes at 0.25, then 0.5 further: 5 N at the end
    const double expected = 3.0 * (0.5 * 5.0 * 1.5 - 0.5 * 5.0 * 0.5);
    EXPECT_NEAR(pathWork(gap, startAt(gap, 1.25, 0.0), -0.25).surplus, expected, 1e-12);
    const Law spring = law(LawKind::Linear);
    EXPECT_NEAR(pathWork(spring, startAt(spring, 1.25, 0.0), -0.25).surplus, 0.0, 1e-12);
}

/// A rigid law has the force that it was found to have; strain tells nothing of it, and nothing is stored.
TEST(StepLaw, PathsOfRigidLawsStartFromTheForceThatWasFound) {
    Law friction = law(LawKind::Capped);
    friction.rigid = true;
    friction.limit = 4.0;
    friction.offset = -friction.limit / friction.stiffness;  // slides from any strain above 0
    const PathWork loaded = pathWork(friction, {0.0, 0.0, 0.0}, 0.5);  // limit and force grow together
    EXPECT_DOUBLE_EQ(loaded.slipForce, 2.0);
    EXPECT_NEAR(loaded.surplus, 0.0, 1e-12);
    const PathWork early = pathWork(friction, {0.0, 0.0, 4.0}, 0.5);  // 4 N all the way, where a trapezium sees 2
    EXPECT_DOUBLE_EQ(early.slipForce, 4.0);
    EXPECT_NEAR(early.surplus, -friction.share * 2.0 * 0.5, 1e-12);
    Law gap = law(LawKind::Gap);
    gap.rigid = true;
    gap.offset = 5.0 / gap.stiffness;  // 5 N at strain 0
    EXPECT_NEAR(pathWork(gap, {0.75, 0.0, 0.0}, 0.0).surplus, gap.share * 0.5 * 5.0 * 0.75, 1e-12);
}

}  // namespace
}  // namespace keyblock
