// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The reference numbers of the verification, made afresh by the independent
// calculation, and that calculation against closed forms.
#include "solver/verify/paper_steel.h"
#include "solver/verify/references.h"
#include "solver/verify/scenes.h"
#include "tests/verify/reference/bolts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace keyblock {
namespace {

using namespace reference;

std::vector<int> nodesOf(const std::vector<BarEvent>& releases) {
    std::vector<int> nodes;
    for (const BarEvent& event : releases) nodes.push_back(event.node);
    return nodes;
}

double largestAnchor(const BarProblem& problem, const BarResult& result) {
    double largest = 0.0;
    for (std::size_t i = 0; i < problem.springs.size(); ++i)
        if (!problem.springs[i].plate) largest = std::max(largest, std::abs(result.springForce[i]));
    return largest;
}

TEST(BarReference, RebarOfThePaper) {
    for (const RebarReference& r : rebarReferences) {
        SCOPED_TRACE(std::string(r.title) + ", divisions " + std::to_string(r.divisions));
        const Mesh mesh = r.divisions == 59 ? Mesh::JointInElement : Mesh::JointAtNode;
        const BarResult result = pullTo(reference::paperRebar(r.youngsModulus, r.peak, mesh), 6e-3);
        const std::vector<BarEvent> releases = result.releases();
        ASSERT_EQ(static_cast<int>(releases.size()), r.releases);
        EXPECT_NEAR(releases.front().load, r.firstLoad, 0.06);
        EXPECT_NEAR(releases.front().opening, r.firstOpening, 1e-9);
        EXPECT_NEAR(result.largestLoad(), r.largestLoad, 0.06);
        EXPECT_NEAR(result.openingAtLargestLoad(), r.largestOpening, 1e-9);
        EXPECT_NEAR(releases.back().opening, r.lastOpening, 1e-9);
        EXPECT_NEAR(result.path.back().second, rebarResidual, 1e-6);
        EXPECT_EQ(nodesOf(releases), rebarOrder(r.divisions, r.releases));
    }
}

TEST(BarReference, BrittleDebondingReleaseByRelease) {
    const std::vector<BarEvent> releases =
        pullTo(reference::paperRebar(200e9, 24.56e3, Mesh::JointInElement), 6e-3).releases();
    ASSERT_EQ(releases.size(), brittleDebonding.size());
    for (std::size_t i = 0; i < releases.size(); ++i) {
        EXPECT_EQ(releases[i].node, brittleDebonding[i].node);
        EXPECT_NEAR(releases[i].load, brittleDebonding[i].load, 1e-3);
        EXPECT_NEAR(releases[i].opening, brittleDebonding[i].opening, 1e-8);
    }
    EXPECT_NEAR(releases.front().load, 128.735e3, 0.5);
    EXPECT_NEAR(releases.front().opening, 0.6477e-3, 0.5e-7);
    EXPECT_NEAR(releases.back().opening, 3.9394e-3, 0.5e-7);
}

/// With λ² = k/EA, a bond of strength q per metre on 1 m lets go first at q/λ·tanh λ; with d of it slipping at r the
/// force is r·d + q/λ·tanh λ(1 − d), which is largest where cosh² λ(1 − d) = q/r.
TEST(BarReference, BrittleDebondingNearsTheContinuum) {
    const double stiffness = 200e9 * reference::barArea, bond = 84.78e6 * 30, q = 24.56e3 * 30, r = 2.24e3 * 30;
    const double lambda = std::sqrt(bond / stiffness);
    const double first = q / lambda * std::tanh(lambda);
    const double left = std::acosh(std::sqrt(q / r)) / lambda;
    const double largest = r * (1.0 - left) + q / lambda * std::tanh(lambda * left);
    EXPECT_NEAR(first, 115.81e3, 5.0);
    EXPECT_NEAR(largest, 157.88e3, 5.0);
    double lastFirst = 0.0, lastLargest = 0.0;
    for (const int finer : {1, 2, 4}) {
        const int perSide = 30 * finer;
        BarProblem p;
        const double h = 1.0 / perSide;
        p.s = evenNodes(0.5 * h, 2.0 - 0.5 * h, 2 * perSide - 1);
        p.area = reference::barArea;
        p.steel = {{1.0, 200e9}};
        anchorEveryNode(p, {{1.0, bond * h}}, q * h, r * h);
        const BarResult result = pullTo(p, 5e-3);
        const double gapFirst = result.releases().front().load - first, gapLargest = result.largestLoad() - largest;
        if (finer > 1) {
            EXPECT_NEAR(gapFirst / lastFirst, 0.5, 0.05);
            EXPECT_NEAR(gapLargest / lastLargest, 0.5, 0.05);
        }
        lastFirst = gapFirst;
        lastLargest = gapLargest;
    }
}

TEST(BarReference, DBoltOfThePaper) {
    for (const DBoltReference& r : dBoltReferences) {
        SCOPED_TRACE(r.title);
        const BarResult result =
            pullTo(reference::paperDBolt(r.tableSteel ? reference::tableSteel : reference::textSteel, r.plate), 0.3);
        const auto yield = result.first(BarEventKind::Corner), rupture = result.first(BarEventKind::Rupture);
        ASSERT_TRUE(yield && rupture);
        EXPECT_NEAR(yield->load, r.yieldLoad, 0.6);
        EXPECT_NEAR(yield->opening, r.yieldOpening, 0.6e-7);
        EXPECT_NEAR(result.loadAt(0.05), r.loadAt50, 0.6);
        EXPECT_NEAR(result.loadAt(0.1), r.loadAt100, 0.6);
        EXPECT_NEAR(rupture->opening, r.ruptureOpening, 0.6e-6);
        EXPECT_NEAR(rupture->load, r.ruptureLoad, 0.6);
    }
}

TEST(BarReference, ElasticRebarOfThePaper) {
    for (const ElasticRebarReference& r : elasticRebarReferences) {
        SCOPED_TRACE(r.stiffness);
        BarProblem problem = reference::elasticRebar(r.stiffness, 1e9);
        makeRockElastic(problem, rigidRock);
        const BarResult result = loadTo(problem, 200e3);
        EXPECT_NEAR(result.path.back().first, r.opening, 1e-9);
        EXPECT_NEAR(result.springForce.back(), r.plate, 1e-4 * r.plate);
        EXPECT_NEAR(largestAnchor(problem, result), r.largestAnchor, 0.01);
        EXPECT_NEAR(result.elementForce[20], r.force20, 0.01);
    }
}

TEST(BarReference, ShearLagWithoutPlate) {
    for (const ShearLagReference& r : shearLagReferences) {
        const BarResult result = loadTo(shearLag(r.perSide, 0.0), 200e3);
        const auto forceAt = [&](double x) {
            return result.elementForce[static_cast<std::size_t>(x * r.perSide - 0.5)];
        };
        EXPECT_NEAR(0.5 * result.path.back().first, r.slip, 1e-9);
        EXPECT_NEAR(forceAt(1.25), r.quarter, 0.1);
        EXPECT_NEAR(forceAt(1.5), r.half, 0.1);
    }
}

/// N(x) = P·sinh λ(1 − x)/sinh λ, slip P/(EAλ·tanh λ); with a rigid plate P/cosh λ and P·tanh λ/(EAλ).
TEST(BarReference, ShearLagNearsTheContinuum) {
    const double stiffness = 200e9 * reference::barArea, lambda = std::sqrt(254.34e6 / stiffness), load = 200e3;
    EXPECT_NEAR(load * std::sinh(0.75 * lambda) / std::sinh(lambda), 117.12e3, 5.0);
    EXPECT_NEAR(load * std::sinh(0.5 * lambda) / std::sinh(lambda), 64.51e3, 5.0);
    const double slip = load / (stiffness * lambda * std::tanh(lambda));
    EXPECT_NEAR(slip, 1.6397e-3, 0.5e-7);
    EXPECT_NEAR(load / std::cosh(lambda), 52.55e3, 5.0);
    EXPECT_NEAR(load * std::tanh(lambda) / (stiffness * lambda), 1.5265e-3, 0.5e-7);
    const double coarse = shearLagReferences[0].slip - slip, fine = shearLagReferences[1].slip - slip;
    EXPECT_NEAR(coarse / fine, 4.0, 0.05);
    const double plateCoarse = 100 * plateLagReferences[0].plate - load / std::cosh(lambda);
    const double plateFine = 100 * plateLagReferences[1].plate - load / std::cosh(lambda);
    EXPECT_NEAR(plateCoarse / plateFine, 81.0 * 81.0 / (41.0 * 41.0), 0.1);  // the plate of 1e13 N/m gives a little
}

TEST(BarReference, ShearLagWithPlate) {
    for (const PlateLagReference& r : plateLagReferences) {
        const BarResult without = loadTo(shearLagByLength(r.divisions, 0.0), 2e3);
        const BarResult with = loadTo(shearLagByLength(r.divisions, 1e13), 2e3);
        EXPECT_NEAR(without.path.back().first, r.openingWithout, 1e-12);
        EXPECT_NEAR(with.path.back().first, r.openingWith, 1e-12);
        EXPECT_NEAR(with.springForce.back(), r.plate, 1e-4);
    }
}

/// A long cable on a perfectly plastic bond, two free divisions to its head: P² = (q/λ)² + 2·EA·q·(u − q/k) at the
/// collar.
TEST(BarReference, GroutedCable) {
    const double area = 181e-6, modulus = 98.6e9, q = 0.175e6, k = 112e6, h = 17.7 / 200;
    BarProblem p;
    p.s = evenNodes(0.0, 17.7 + 2 * h, 202);
    p.area = area;
    p.steel = {{1.0, modulus}};
    p.breaksAt = 500e3;
    for (int i = 0; i <= 200; ++i) {
        const double length = i == 0 || i == 200 ? 0.5 * h : h, slip = q / k;
        p.springs.push_back({i, Side::Fixed, {{slip, q * length}, {1.0, q * length}}, std::nullopt, 0.0, false});
    }
    p.springs.push_back({202, Side::Moving, {{1.0, 1e13}}, std::nullopt, 0.0, true});
    const BarResult result = pullTo(p, 0.05);
    const double stretch = 2 * h / (area * modulus);  // [m/N] from the collar to the head
    EXPECT_NEAR(result.path[1].second, 69.86e3, 0.01 * 69.86e3);
    EXPECT_NEAR(result.path[1].first - stretch * result.path[1].second, 1.5625e-3, 1e-7);
    const double force = 427.2e3;
    EXPECT_NEAR(result.loadAt(0.03 + stretch * force), force, 0.002 * force);
    const auto rupture = result.first(BarEventKind::Rupture);
    ASSERT_TRUE(rupture);
    EXPECT_NEAR(rupture->opening - stretch * 500e3, 40.80e-3, 0.005 * 40.80e-3);
    EXPECT_NEAR(rupture->load, 500e3, 1.0);
}

TEST(BarReference, ProgramUsesTheSameSteels) {
    const auto withoutOrigin = [](const Table& table) { return Curve(table.begin() + 1, table.end()); };
    EXPECT_EQ(withoutOrigin(keyblock::textSteel), reference::textSteel);
    EXPECT_EQ(withoutOrigin(keyblock::tableSteel), reference::tableSteel);
}

}  // namespace
}  // namespace keyblock
