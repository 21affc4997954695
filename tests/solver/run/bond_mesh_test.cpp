// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bonded bolts whose divisions are left to the program: what a pull takes,
// against closed forms, the exact sum over the nodes, and a finer mesh.
#include "solver/engine/setup/make_model.h"
#include "solver/engine/setup/mesh_check.h"
#include "solver/verify/readings.h"
#include "solver/verify/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace keyblock {
namespace {

/// A bar bonded over its whole length, per metre of it.
struct BondedBar {
    double length = 2.0, joint = 0.5;  // [m]
    double axial = 200e9 * std::numbers::pi * 1e-4;  // EA [N]
    double bond = 2543.4e6, peak = 736.8e3, residual = 67.2e3;  // [N/m², N/m]

    double lambda() const { return std::sqrt(bond / axial); }
};

Scene sceneOf(const BondedBar& bar, const Anchor& anchor) {
    Scene scene = twoBlocks(rigidRock, bar.joint, bar.length);
    BoltType type = linearType(barArea(), bar.axial / barArea());
    type.anchors = {anchor};
    addBolt(scene, type, 0.0, bar.length, 1, PlateKind::None);
    scene.bolts[0].divisions.reset();
    return scene;
}

/// Opening of the joint under a pull N: each end slips by N·coth(λℓ)/EAλ.
double elasticOpening(const BondedBar& bar, double pull) {
    const double l = bar.lambda();
    return pull / (bar.axial * l) * (1.0 / std::tanh(l * bar.joint) + 1.0 / std::tanh(l * (bar.length - bar.joint)));
}

TEST(BondMesh, ElasticCablesOpenAsTheClosedFormSays) {
    for (const double bond : {2543.4e6, 112e6})
        for (const double length : {2.0, 6.0, 20.0, 50.0}) {
            BondedBar bar;
            bar.length = length;
            bar.joint = 0.25 * length;
            bar.bond = bond;
            Scene scene = sceneOf(bar, anchorRange(Per::Length, AnchorLaw::Elastic, bond, std::nullopt, 0.0));
            scene.stages = {loadStage(scene, 1e3, 1)};
            const double opening = elasticOpening(bar, 1e3);
            EXPECT_NEAR(reading(solve(scene), "last opening"), opening, 0.01 * opening) << bond << " over " << length;
        }
}

/// One side of a joint that has debonded over c: at the front strength/λ·tanh(λ(ℓ − c)), along c the residual (Li
/// and Stillborg 1999).
struct DebondedSide {
    double slip = 0.0, pull = 0.0;
};

DebondedSide debonded(const BondedBar& bar, double embedded, double c) {
    const double front = bar.peak / bar.lambda() * std::tanh(bar.lambda() * (embedded - c));
    return {bar.peak / bar.bond + (front * c + 0.5 * bar.residual * c * c) / bar.axial, front + bar.residual * c};
}

/// Pull at an opening that both sides share, each far longer than what has debonded.
double brittlePull(const BondedBar& bar, double opening) {
    double low = 0.0, high = std::min(bar.joint, bar.length - bar.joint);
    for (int i = 0; i < 100; ++i) {
        const double c = 0.5 * (low + high);
        (2.0 * debonded(bar, bar.joint, c).slip < opening ? low : high) = c;
    }
    return debonded(bar, bar.joint, low).pull;
}

/// The exact sum over the nodes of a mesh: bars between nodes, a spring at each until its strength is reached, then the
/// residual; one debonds at a time, the most overloaded first.
class NodeSum {
public:
    NodeSum(const BondedBar& bar, const std::vector<double>& nodes) : bar_(bar), nodes_(nodes), bonded_(nodes.size(), true) {}

    /// Pull once the opening has risen to `opening`.
    double pullAt(double opening) {
        for (;;) {
            const std::vector<double> at0 = solve(0.0), at1 = solve(1.0);
            double next = opening;
            std::size_t first = nodes_.size();
            for (std::size_t i = 0; i < nodes_.size(); ++i) {
                const double rate = at1[i] - at0[i], sign = left(i) ? 1.0 : -1.0;
                if (!bonded_[i] || sign * rate <= 0.0) continue;
                const double when = (sign * bar_.peak / bar_.bond - at0[i]) / rate;
                if (when < next) {
                    next = when;
                    first = i;
                }
            }
            if (first == nodes_.size()) {
                const std::vector<double> now = solve(opening);
                const std::size_t e = lastLeft();
                return bar_.axial / (nodes_[e + 1] - nodes_[e]) * (now[e + 1] + opening - now[e]);
            }
            bonded_[first] = false;
        }
    }

private:
    bool left(std::size_t i) const { return nodes_[i] < bar_.joint; }
    std::size_t lastLeft() const {
        std::size_t e = 0;
        while (left(e + 1)) ++e;
        return e;
    }
    double tributary(std::size_t i) const {  // within its own block
        const double before = i > 0 ? 0.5 * (nodes_[i] + nodes_[i - 1]) : nodes_[i];
        const double after = i + 1 < nodes_.size() ? 0.5 * (nodes_[i] + nodes_[i + 1]) : nodes_[i];
        return after - before;
    }

    /// Slip of the bar against its block at every node (positive towards the head), the blocks `opening` apart.
    std::vector<double> solve(double opening) const {
        const std::size_t n = nodes_.size();
        std::vector<double> diagonal(n), beside(n, 0.0), force(n, 0.0);
        for (std::size_t i = 0; i < n; ++i) {
            const double t = tributary(i);
            if (bonded_[i]) diagonal[i] += bar_.bond * t;
            else force[i] -= (left(i) ? 1.0 : -1.0) * bar_.residual * t;
        }
        for (std::size_t e = 0; e + 1 < n; ++e) {
            const double k = bar_.axial / (nodes_[e + 1] - nodes_[e]);
            diagonal[e] += k;
            diagonal[e + 1] += k;
            beside[e] = -k;
            if (e != lastLeft()) continue;
            force[e] += k * opening;
            force[e + 1] -= k * opening;
        }
        for (std::size_t i = 1; i < n; ++i) {
            const double share = beside[i - 1] / diagonal[i - 1];
            diagonal[i] -= share * beside[i - 1];
            force[i] -= share * force[i - 1];
        }
        for (std::size_t i = n; i-- > 0;) force[i] = (force[i] - (i + 1 < n ? beside[i] * force[i + 1] : 0.0)) / diagonal[i];
        return force;
    }

    BondedBar bar_;
    std::vector<double> nodes_;
    std::vector<bool> bonded_;
};

TEST(BondMesh, ABrittleCableFollowsTheContinuum) {
    BondedBar bar;
    bar.length = 6.0;
    bar.joint = 3.0;
    bar.axial = 200e9 * 0.25 * std::numbers::pi * 0.0152 * 0.0152;
    Anchor brittle = anchorRange(Per::Length, AnchorLaw::PeakResidual, bar.bond, bar.peak, bar.residual);
    brittle.restick = false;
    Scene scene = sceneOf(bar, brittle);
    scene.stages = {pullStage(scene, 10e-3, 10)};
    const Solved solved = solve(scene);
    NodeSum sum(bar, makeModel(scene).bolts[0].s);
    const std::vector<double> openings = series(solved, "opening"), pulls = series(solved, "joint force");
    for (const double opening : {1e-3, 3e-3, 6e-3, 10e-3}) {
        std::size_t row = 0;
        while (openings[row] < opening * (1.0 - 1e-6)) ++row;
        const double continuum = brittlePull(bar, opening), share = opening < 2e-3 ? 0.1 : 0.05;
        EXPECT_NEAR(pulls[row], continuum, share * continuum) << opening;
        const double exact = sum.pullAt(openings[row]);
        EXPECT_NEAR(pulls[row], exact, 5e-3 * exact) << opening;
    }
}

TEST(BondMesh, ASofteningBondDoesNotDependOnTheMesh) {
    BondedBar bar;
    bar.length = 0.6;
    bar.joint = 0.3;
    Anchor soft = anchorRange(Per::Length, AnchorLaw::PeakResidual, bar.bond, bar.peak, bar.residual);
    soft.softeningSlip = 1e-3;
    Scene scene = sceneOf(bar, soft);
    scene.analysis.tolerance = 1e-4;
    scene.stages = {pullStage(scene, 1.2e-3, 3)};
    const Solved coarse = solve(scene);
    const auto nodes = static_cast<int>(makeModel(scene).bolts[0].s.size());
    scene.bolts[0].divisions = 2 * nodes + 1;
    const Solved fine = solve(scene);
    const double onset = reading(fine, "first debonding joint force"), peak = reading(fine, "max joint force");
    EXPECT_NEAR(reading(coarse, "first debonding joint force"), onset, 0.05 * onset);
    EXPECT_NEAR(reading(coarse, "max joint force"), peak, 0.02 * peak);
    EXPECT_LT(peak, bar.peak * bar.joint);
}

/// Griffith: the front of a bond on a long bar carries √(2·EA·G), G the work per area of its whole curve.
TEST(BondMesh, TheFrontOfASofteningBondCarriesItsFractureEnergy) {
    BondedBar bar;
    bar.length = 1.6;
    bar.joint = 0.8;
    bar.residual = 0.0;
    Anchor soft = anchorRange(Per::Length, AnchorLaw::PeakResidual, bar.bond, bar.peak, 0.0);
    soft.softeningSlip = 2e-4;
    Scene scene = sceneOf(bar, soft);
    scene.analysis.tolerance = 1e-4;
    scene.stages = {pullStage(scene, 1.2e-3, 3)};
    const double work = 0.5 * bar.peak * (bar.peak / bar.bond + soft.softeningSlip);
    const double front = std::sqrt(2.0 * bar.axial * work);
    EXPECT_NEAR(reading(solve(scene), "max joint force"), front, 0.02 * front);
}

TEST(BondMesh, ElementsTooLongForTheBondAreReportedWithTheirCost) {
    BondedBar bar;
    Scene scene = sceneOf(bar, anchorRange(Per::Length, AnchorLaw::Elastic, bar.bond, std::nullopt, 0.0));
    const auto messages = [&] {
        std::string all;
        for (const Problem& problem : checkMeshes(scene)) all += problem.message;
        return all;
    };
    EXPECT_EQ(messages(), "");
    scene.bolts[0].divisions = 3;  // 0.667 m, 4.24 of 1/λ: √(1 + 2.12²) − 1 = 1.34
    EXPECT_NE(messages().find("opens 134 % too far"), std::string::npos) << messages();
    scene.bolts[0].divisions = 61;
    EXPECT_EQ(messages(), "");
}

}  // namespace
}  // namespace keyblock
