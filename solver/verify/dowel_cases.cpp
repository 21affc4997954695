// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A bolt across a joint that is sheared, and a bolt whose anchor slips while a
// block slides on a plane.
#include "solver/verify/checks.h"
#include "solver/verify/groups.h"
#include "solver/verify/paper_steel.h"
#include "solver/verify/readings.h"
#include "solver/verify/scenes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace keyblock {

namespace {

// [N/m²] 2·E_g/(D/d − 1) with E_g = 8.8 GPa, a hole of D = 33 mm and a bar of d = 20 mm
constexpr double grout = 27.08e9;

Monitor jointQuantity(const Scene& scene, const std::string& name, BoltQuantity quantity) {
    Monitor monitor = scene.monitors.back();
    monitor.name = name;
    monitor.quantity = quantity;
    return monitor;
}

/// Moves the right block along the joint.
Stage shearStage(const Scene& scene, double displacement, int increments) {
    Stage stage = pullStage(scene, displacement, increments);
    stage.name = "shear";
    stage.motions[0].axis = {0.0, 1.0};
    return stage;
}

/// A bolt across the joint with `elements` elements of `length` [m] each; the joint is in the middle of one of them.
/// Weak anchors at the ends of the bolt hold the blocks together without tensioning the bar as it bends.
Scene shearedJoint(BoltType type, double length, int elements, double displacement, int increments) {
    Scene scene = twoBlocks(rigidRock, 1.0, 2.0);
    const double reach = 0.5 * length * elements;
    type.anchors = {anchorAt(0.0, AnchorLaw::Elastic, 1e6), anchorAt(2.0 * reach, AnchorLaw::Elastic, 1e6)};
    addBolt(scene, type, 1.0 - reach, 1.0 + reach, elements, PlateKind::None);
    scene.monitors.push_back(jointQuantity(scene, "shear force", BoltQuantity::ShearForce));
    scene.stages = {shearStage(scene, displacement, increments)};
    return scene;
}

/// Position [m] and value of the extremum of the parabola through three points at x − h, x and x + h.
std::pair<double, double> topOf(double x, double h, double left, double middle, double right) {
    const double curvature = left - 2.0 * middle + right, slope = 0.5 * (right - left);
    return {x - h * slope / curvature, middle - 0.5 * slope * slope / curvature};
}

/// A beam on an elastic foundation K with half of the joint's displacement at x = 0: the shear force is Q = EIβ³ ×
/// displacement with β = (K/4EI)^¼. The moment Q/β·e^(−βx)·sin βx is largest at x = π/4β.
std::vector<CaseResult> dowel() {
    Checks checks("dowel");
    const double h = 2.5e-3, shear = 20e-6, d = 0.02;
    BoltType type = linearType(barArea(), 200e9);
    type.bending = Bending::Elastic;
    type.normalStiffness = grout;
    type.normalPer = Per::Length;
    type.shearCoefficient = 1e-9;  // suppresses the shear deformation of the bar (b = 0)
    const Solved solved = solve(shearedJoint(type, h, 243, shear, 1));
    const double q = std::abs(reading(solved, "last shear force"));
    checks.relative("stiffness of the joint [N/m]", q / shear, 148.6e6, 1e-2);
    const std::vector<BoltNodeFrame>& nodes = solved.results.frames.back().bolts[0].nodes;
    std::size_t most = 123;
    for (std::size_t n = 123; n + 1 < nodes.size(); ++n)
        if (std::abs(nodes[n].moment) > std::abs(nodes[most].moment)) most = n;
    const auto size = [&](std::size_t n) { return std::abs(nodes[n].moment); };
    const auto [place, moment] = topOf(nodes[most].s - 121.5 * h, h, size(most - 1), size(most), size(most + 1));
    checks.relative("largest moment from the joint [m]", place, 17.2e-3, 3e-2);
    const double yields = 490e6 * std::numbers::pi * d * d * d / 32.0;
    checks.relative("shear force at first yield [N]", q * yields / moment, 54.4e3, 1e-2);
    return checks.take();
}

/// The bar ruptures in shear at 0.6·A·630 MPa.
std::vector<CaseResult> guillotine() {
    Checks checks("guillotine");
    BoltType type = steelType(barArea(), textSteel);
    type.normalStiffness = 1e12;
    const Solved solved = solve(shearedJoint(type, 5e-3, 81, 2e-3, 20));
    checks.absolute("shear ruptures", countOf(solved, EventKind::ShearRupture), 1.0, 0.0);
    const double force = std::abs(reading(solved, "first shear-rupture shear force"));
    checks.relative("shear force at rupture [N]", force, 118.75e3, 2e-2);
    checks.absolute("shear force after it [N]", std::abs(reading(solved, "last shear force")), 0.0, 1.0);
    return checks.take();
}

constexpr double planeAngle = 42.0 * degree, boltAngle = 15.0 * degree, frictionAngle = 36.0;

/// Point at a distance `along` down the plane and `up` normal to it [m].
Point onPlane(double along, double up) {
    const Point down(std::cos(planeAngle), -std::sin(planeAngle)), out(std::sin(planeAngle), std::cos(planeAngle));
    return along * down + up * out;
}

Block planeBox(const std::string& name, double from, double to, double low, double high) {
    Block block = boxBlock(name, {0, 0}, {1, 1});
    block.points = {onPlane(from, low), onPlane(to, low), onPlane(to, high), onPlane(from, high)};
    return block;
}

/// A block of 1000 kN, supported by a bar whose anchor in the rock below slips at `force` [N]. The bar is so stiff that
/// the block hardly slides before that. If it did, the bar would have a kink at the joint and pull at a smaller angle.
Scene blockOnPlane(double force) {
    Scene scene = emptyScene(10e9, 0.2, frictionAngle);
    scene.analysis.gravity = {0.0, -gravity};
    scene.materials[0].second.density = 1e6 / (gravity * 4.0 * 2.0);
    scene.blocks = {planeBox("rock", -6.0, 8.0, -4.0, 0.0), planeBox("block", 0.0, 4.0, 0.0, 2.0)};
    Support support;
    support.blockAt = onPlane(1.0, -2.0);
    scene.supports = {support};
    BoltType type = linearType(barArea(), 2e13);
    type.bending = Bending::None;
    Anchor anchor = anchorAt(0.0, AnchorLaw::Frictional, 1e10);
    anchor.strength = force;
    type.anchors = {anchor};
    scene.boltTypes = {type};
    Bolt bolt;
    bolt.name = "B";
    bolt.type = type.name;
    bolt.head = onPlane(4.0, 1.0);
    bolt.farEnd = onPlane(4.0 - 6.0 * std::cos(boltAngle), 1.0 - 6.0 * std::sin(boltAngle));
    bolt.divisions = 59;
    scene.bolts = {bolt};
    Stage settle;
    settle.name = "settle";
    scene.stages = {settle};
    return scene;
}

/// T·(cos δ + sin δ·tan φ) = W·(sin α − cos α·tan φ) gives T = 111.97 kN.
std::vector<CaseResult> boltedBlockOnPlane() {
    Checks checks("block on a plane");
    const auto outcome = [](double force) {
        return solve(blockOnPlane(force)).results.stages.back().outcome;
    };
    const double tanPhi = std::tan(frictionAngle * degree);
    const double exact = 1e6 * (std::sin(planeAngle) - std::cos(planeAngle) * tanPhi) /
                         (std::cos(boltAngle) + std::sin(boltAngle) * tanPhi);
    checks.relative("smallest force that holds it [N]", exact, 111.97e3, 1e-4);
    checks.absolute("stable at 119 kN", outcome(119e3) == Outcome::Equilibrium, 1.0, 0.0);
    checks.absolute("stable at 1 % more than that", outcome(1.01 * exact) == Outcome::Equilibrium, 1.0, 0.0);
    checks.absolute("slides at 1 % less", outcome(0.99 * exact) == Outcome::Collapse, 1.0, 0.0);
    checks.absolute("slides at 105 kN", outcome(105e3) == Outcome::Collapse, 1.0, 0.0);
    return checks.take();
}

}  // namespace

std::vector<Case> dowelCases() {
    return {{"dowel", "A joint sheared across a grouted bar, within elasticity.", dowel},
            {"guillotine", "A bar cut by two blocks.", guillotine},
            {"block on a plane", "A slipping anchor that is or is not strong enough to hold a block.", boltedBlockOnPlane}};
}

}  // namespace keyblock
