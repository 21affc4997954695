// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The numbers that the samples of the paper's bolts say they give, worked out
// again by the independent calculation with the samples' own rock of 60 GPa, and
// the order in which their nodes let go.
#include "solver/files/scene/scene_file.h"
#include "solver/run/run.h"
#include "tests/verify/reference/bolts.h"
#include "tests/verify/reference/softening_bar.h"
#include "tests/verify/sample.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace keyblock {
namespace {

using test::expectedOf;
using test::sample;

using namespace reference;  // the calculation's own bolts, not those of the verification

BarProblem inRock(BarProblem problem) {
    makeRockElastic(problem, rockStiffness);
    return problem;
}

struct RebarSample {
    const char* name;
    double youngsModulus, peak;
};

constexpr RebarSample rebarSamples[]{{"rebar-stated", 213.043e9, 24.56e3},
                                     {"rebar-reading-a", 177e9, 24.56e3},
                                     {"rebar-reading-b", 215.8e9, 22.32e3}};

BarResult pulled(const RebarSample& s) {
    return pullTo(inRock(paperRebar(s.youngsModulus, s.peak, Mesh::JointInElement)), 6e-3);
}

TEST(SampleReference, RebarsExpectTheReference) {
    for (const RebarSample& s : rebarSamples) {
        SCOPED_TRACE(s.name);
        const Scene scene = sample(s.name);
        const BarResult result = pulled(s);
        EXPECT_NEAR(expectedOf(scene, "first debonding joint force"), result.releases().front().load, 0.1);
        EXPECT_NEAR(expectedOf(scene, "first debonding dilation"), result.releases().front().opening, 1e-10);
        EXPECT_NEAR(expectedOf(scene, "max joint force"), result.largestLoad(), 0.1);
        EXPECT_NEAR(expectedOf(scene, "last joint force"), result.path.back().second, 0.1);
    }
}

/// The fixed block is rigid and the other is not, so that the two sides are not alike: the first twelve releases and
/// their number are compared.
TEST(SampleReference, RebarsLetGoInTheReferencesOrder) {
    for (const RebarSample& s : rebarSamples) {
        SCOPED_TRACE(s.name);
        std::vector<int> expected, found;
        for (const BarEvent& event : pulled(s).releases()) expected.push_back(event.node);
        for (const Event& event : runInMemory(sample(s.name)).events)
            if (event.kind == EventKind::Debonding) found.push_back(event.node);
        EXPECT_EQ(found.size(), expected.size());
        ASSERT_GE(found.size(), 12u);
        EXPECT_TRUE(std::equal(found.begin(), found.begin() + 12, expected.begin()));
    }
}

TEST(SampleReference, DBoltsExpectTheReference) {
    for (const bool table : {false, true}) {
        const Scene scene = sample(table ? "dbolt-table-steel" : "dbolt-text-steel");
        const BarResult result = pullTo(inRock(paperDBolt(table ? tableSteel : textSteel, true)), 0.3);
        const auto yield = result.first(BarEventKind::Corner), rupture = result.first(BarEventKind::Rupture);
        ASSERT_TRUE(yield && rupture);
        EXPECT_NEAR(expectedOf(scene, "first yield joint force"), yield->load, 0.1);
        EXPECT_NEAR(expectedOf(scene, "first yield dilation"), yield->opening, 1e-9);
        EXPECT_NEAR(expectedOf(scene, "first tensile-rupture joint force"), rupture->load, 0.1);
        EXPECT_NEAR(expectedOf(scene, "first tensile-rupture dilation"), rupture->opening, 1e-7);
    }
}

TEST(SampleReference, ElasticRebarsExpectTheReference) {
    const std::pair<const char*, double> pairs[]{
        {"rebar-elastic-20", 20e6}, {"rebar-elastic-85", 84.78e6}, {"rebar-elastic-300", 300e6}};
    for (const auto& [name, stiffness] : pairs) {
        SCOPED_TRACE(name);
        const Scene scene = sample(name);
        const BarResult result = loadTo(inRock(elasticRebar(stiffness, 1e9)), 200e3);
        EXPECT_NEAR(expectedOf(scene, "last dilation"), result.path.back().first, 1e-9);
        EXPECT_NEAR(expectedOf(scene, "last B.plate_force"), result.springForce.back(), 0.01);
        EXPECT_NEAR(expectedOf(scene, "last force at 0.683 m"), result.elementForce[20], 0.1);
    }
}

BarSpring endSpring(const Curve& curve, std::optional<double> peak) {
    BarSpring spring;
    spring.curve = curve;
    spring.peak = peak;
    return spring;
}

double circleArea(double diameter) { return 3.14159265358979323846 * 0.25 * diameter * diameter; }

TEST(SampleReference, GroutedRebarExpectsTheReference) {
    BarProblem problem = boltAcross(1.0, 2.0, 59, barArea, textSteel);
    BarSpring bond = endSpring({{1.0, 2543.4e6}}, 736.8e3);
    bond.residual = 67.2e3;
    bond.restick = true;
    anchorByLength(problem, 1.0, 0.0, 2.0, bond);
    addPlate(problem, 1e9, 120e3);
    const BarResult result = pullTo(problem, 0.01);
    const auto yield = result.first(BarEventKind::Corner);
    ASSERT_TRUE(yield);
    const Scene scene = sample("rebar-brittle");
    EXPECT_NEAR(expectedOf(scene, "first debonding joint force"), result.releases().front().load, 0.1);
    EXPECT_NEAR(expectedOf(scene, "first debonding dilation"), result.releases().front().opening, 1e-9);
    EXPECT_NEAR(expectedOf(scene, "first yield joint force"), yield->load, 0.1);
    EXPECT_NEAR(expectedOf(scene, "first yield dilation"), yield->opening, 1e-9);
    EXPECT_NEAR(expectedOf(scene, "last joint force"), result.path.back().second, 0.1);
}

TEST(SampleReference, RebarWithASofteningBondExpectsTheContinuousBar) {
    const EmbeddedBar half{1.0, barArea, textSteel, {2543.4e6, 736.8e3, 67.2e3, 7e-3}};
    const Scene scene = sample("rebar-20");
    const double yield = expectedOf(scene, "first yield joint force");
    EXPECT_NEAR(yield, 490e6 * barArea, 1.0);
    EXPECT_NEAR(expectedOf(scene, "first yield dilation"), 2.0 * slipAtForce(half, yield), 1e-9);
    EXPECT_NEAR(expectedOf(scene, "last joint force"), forceAtSlip(half, 0.005), 1.0);
}

TEST(SampleReference, BoltsHeldAtTheirEndsExpectTheReference) {
    BarProblem shell = boltAcross(1.0, 2.0, 20, 235e-6, {{1.0, 200e9}});
    shell.springs = {endSpring({{1.0, 40e6}}, 85e3)};
    addPlate(shell, 1e9, 89e3);
    const BarEvent lost = pullTo(shell, 0.01).releases().front();
    EXPECT_NEAR(expectedOf(sample("expansion-shell"), "first bolt-loss joint force"), lost.load, 0.1);
    EXPECT_NEAR(expectedOf(sample("expansion-shell"), "first bolt-loss dilation"), lost.opening, 1e-9);

    BarProblem cone = boltAcross(1.5, 2.3, 46, circleArea(0.0172), {{0.00296, 592e6}, {0.12, 800e6}});
    cone.springs = {endSpring({{0.00156, 78e3}, {0.6, 98e3}}, std::nullopt)};
    addPlate(cone, 1e9, 150e3);
    const BarResult ploughs = pullTo(cone, 0.2);
    EXPECT_NEAR(expectedOf(sample("cone-bolt"), "first debonding joint force"), ploughs.path[1].second, 0.1);
    EXPECT_NEAR(expectedOf(sample("cone-bolt"), "first debonding dilation"), ploughs.path[1].first, 1e-9);
    EXPECT_NEAR(expectedOf(sample("cone-bolt"), "last joint force"), ploughs.path.back().second, 0.1);
}

TEST(SampleReference, BoltsThatSlipThroughTheirAnchorExpectTheReference) {
    BarProblem roofex = boltAcross(1.5, 2.4, 48, circleArea(0.0125), {{0.004, 800e6}, {0.1, 815e6}});
    anchorByLength(roofex, 1.5, 0.0, 0.35,
                   endSpring({{0.0008, 228571.429}, {0.6, 228571.429}, {0.62, 285714.286}}, std::nullopt));
    addPlate(roofex, 1e9, 100e3);
    EXPECT_NEAR(expectedOf(sample("roofex"), "last joint force"), pullTo(roofex, 0.615).path.back().second, 0.1);

    BarProblem garford = boltAcross(1.5, 2.4, 48, barArea, {{0.0025, 500e6}, {0.15, 605e6}});
    anchorByLength(garford, 1.5, 0.0, 0.35,
                   endSpring({{0.0012, 342857.143}, {0.35, 342857.143}, {0.37, 400e3}}, std::nullopt));
    addPlate(garford, 1e9, 150e3);
    EXPECT_NEAR(expectedOf(sample("garford"), "last joint force"), pullTo(garford, 0.365).path.back().second, 0.1);
}

}  // namespace
}  // namespace keyblock
