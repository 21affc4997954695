// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bolts whose divisions are left to the program, through many blocks and where
// joints lie badly for them: what they carry, against closed forms.
#include "solver/engine/setup/mesh_check.h"
#include "solver/run/run.h"
#include "solver/verify/readings.h"
#include "solver/verify/scenes.h"
#include "tests/solver/run/small_stages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

namespace keyblock {
namespace {

constexpr double modulus = 200e9, bond = 254.34e6;  // [Pa], [N/m²] along the bolt
constexpr double grout = 27.08e9;  // [N/m²] across it
constexpr int many = 10;

BoltType barType() {
    BoltType type = linearType(barArea(), modulus);
    type.bending = Bending::Elastic;
    type.anchors = {anchorRange(Per::Length, AnchorLaw::Elastic, bond, std::nullopt, 0.0)};
    type.normalStiffness = grout;
    type.normalPer = Per::Length;
    type.shearCoefficient = 1e-9;  // no shear of the bar
    return type;
}

/// Rigid smooth blocks in a row from 0 on, joints at the places given; the first is held.
Scene row(const std::vector<double>& ends) {
    Scene scene = emptyScene(rigidRock, 0.17, 0.0);
    double from = 0.0;
    for (double to : ends) {
        scene.blocks.push_back(boxBlock("block " + std::to_string(scene.blocks.size() + 1), {from, 0}, {to, 1}));
        from = to;
    }
    Support support;
    support.blockAt = Point(0.5 * ends.front(), 0.1);
    scene.supports = {support};
    scene.analysis.tolerance = 1e-9;  // stiff springs round off more
    return scene;
}

void addBar(Scene& scene, double from, double to) {
    addBolt(scene, barType(), from, to, 1, PlateKind::None);
    scene.bolts.back().divisions.reset();
}

Motion motionOf(double x, const Point& axis, double way) {
    Motion motion;
    motion.blockAt = Point(x, 0.1);
    motion.axis = axis;
    motion.table = {{0.0, 0.0}, {1.0, way}};
    return motion;
}

/// Axial force in the element that holds `s`.
double axialAt(const Frame& frame, double s) {
    const std::vector<BoltNodeFrame>& nodes = frame.bolts[0].nodes;
    std::size_t n = 0;
    while (n + 2 < nodes.size() && nodes[n + 1].s < s) ++n;
    return nodes[n].axialForce;
}

double shearAt(const Frame& frame, double s) {
    const std::vector<BoltNodeFrame>& nodes = frame.bolts[0].nodes;
    std::size_t n = 0;
    while (n + 2 < nodes.size() && nodes[n + 1].s < s) ++n;
    return nodes[n].shearForce;
}

double lambda() { return std::sqrt(bond / (modulus * barArea())); }

/// Slip of the bar against a block per unit of force where it leaves it, the other end free: coth(λℓ)/EAλ.
double freeEnd(double length) { return 1.0 / (std::tanh(lambda() * length) * modulus * barArea() * lambda()); }

/// The same of a block through which the force goes on to the next: tanh(λℓ/2)/EAλ.
double goesOn(double length) { return std::tanh(0.5 * lambda() * length) / (modulus * barArea() * lambda()); }

/// What holds a block free along the bar is nothing, so every joint carries the same force, and all of them open.
TEST(BoltDivisions, TenBlocksArePulledApartAsSpringsInSeries) {
    std::vector<double> ends;
    for (int i = 1; i <= many; ++i) ends.push_back(0.2 * i);
    Scene scene = row(ends);
    addBar(scene, 0.0, ends.back());
    scene.stages = {test::settle()};
    const double way = 1e-4;  // ten times that draws 0.3 mm of the bar out of the first block, 1e-3 of the force
    scene.stages[0].motions = {motionOf(1.9, {1.0, 0.0}, way)};
    scene.stages[0].increments = 1;
    const Results results = runInMemory(scene);
    ASSERT_EQ(results.stages[0].outcome, Outcome::Equilibrium) << results.stages[0].message;
    const double force = way / (2.0 * freeEnd(0.2) + 2.0 * (many - 2) * goesOn(0.2));
    for (int i = 0; i + 1 < many; ++i) EXPECT_NEAR(axialAt(results.frames.back(), ends[i]), force, 1e-3 * force) << i;
}

/// Joints are nine lengths 1/β apart: a sheared one is a dowel between half-spaces, Q = EIβ³ × displacement.
TEST(BoltDivisions, OneShearedJointOfTenIsADowel) {
    std::vector<double> ends;
    for (int i = 1; i <= many; ++i) ends.push_back(0.2 * i);
    Scene scene = row(ends);
    addBar(scene, 0.0, ends.back());
    scene.stages = {test::settle()};
    const double way = 20e-6;
    for (int i = 1; i < many; ++i)
        scene.stages[0].motions.push_back(motionOf(0.2 * i + 0.1, {0.0, 1.0}, i < 5 ? 0.0 : way));
    scene.stages[0].increments = 1;
    const Results results = runInMemory(scene);
    ASSERT_EQ(results.stages[0].outcome, Outcome::Equilibrium) << results.stages[0].message;
    EXPECT_NEAR(std::abs(shearAt(results.frames.back(), 1.0)), 148.6e6 * way, 1e-2 * 148.6e6 * way);
    EXPECT_NEAR(shearAt(results.frames.back(), 0.6), 0.0, 1e-2 * 148.6e6 * way);
}

/// The bar begins on one joint and crosses another: the block between holds it over its whole length.
TEST(BoltDivisions, ABarThatBeginsOrEndsOnAJointIsHeldByTheBlockItIsIn) {
    for (const bool mirrored : {false, true}) {
        Scene scene = row({0.5, 1.0, 1.5});
        addBar(scene, mirrored ? 0.0 : 0.5, mirrored ? 1.0 : 1.5);
        scene.stages = {test::settle()};
        const double way = 1e-4;
        const double joint = mirrored ? 0.5 : 1.0;
        scene.stages[0].motions = {motionOf(0.75, {1.0, 0.0}, mirrored ? way : 0.0), motionOf(1.25, {1.0, 0.0}, way)};
        scene.stages[0].increments = 4;
        const Results results = runInMemory(scene);
        ASSERT_EQ(results.stages[0].outcome, Outcome::Equilibrium) << results.stages[0].message;
        const double force = way / (2.0 * freeEnd(0.5));
        EXPECT_NEAR(axialAt(results.frames.back(), joint - (mirrored ? 0.0 : 0.5)), force, 1e-3 * force) << mirrored;
        EXPECT_LT(std::abs(results.stages[0].health.balanceError), 1e-4);
    }
}

/// An anchor whose node comes to lie on a joint carries nothing, which the user must know; on the bar's end it holds.
TEST(BoltDivisions, WarnOfAnAnchorOnAJoint) {
    for (const double at : {0.5, 0.25, 0.0}) {
        Scene scene = row({0.5, 1.0, 1.5});
        addBar(scene, 0.5, 1.5);
        scene.bolts[0].divisions = 20;  // a node on the joint
        scene.bolts[0].anchors = {anchorAt(at, AnchorLaw::Elastic, 1e8)};
        const std::vector<Problem> problems = checkMeshes(scene);
        const bool reported = std::any_of(problems.begin(), problems.end(),
                                          [](const Problem& p) { return p.pointer == "/bolts/0/anchors/0/at"; });
        EXPECT_EQ(reported, at == 0.5) << at;
    }
}

TEST(BoltDivisions, WarnOfAnchorsPerNodeOnAutomaticDivisions) {
    const auto warnings = [](Per per, std::optional<int> divisions) {
        Scene scene = row({1.0, 2.0});
        addBar(scene, 0.1, 1.9);
        scene.boltTypes.back().anchors = {anchorRange(per, AnchorLaw::Elastic, 1e7, std::nullopt, 0.0)};
        scene.bolts.back().divisions = divisions;
        int found = 0;
        for (const Problem& problem : checkMeshes(scene))
            if (problem.message.find("for each node") != std::string::npos) ++found;
        return found;
    };
    EXPECT_EQ(warnings(Per::Node, {}), 1);
    EXPECT_EQ(warnings(Per::Node, 60), 0);
    EXPECT_EQ(warnings(Per::Length, {}), 0);
}

}  // namespace
}  // namespace keyblock
