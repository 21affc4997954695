// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bolts that keep slipping: with friction along the whole length, or at one end
// only.
#include "solver/verify/checks.h"
#include "solver/verify/groups.h"
#include "solver/verify/readings.h"
#include "solver/verify/scenes.h"

#include <algorithm>
#include <cmath>

namespace keyblock {

namespace {

constexpr double tubeFriction = 54e3;  // [N/m]

/// A friction tube of 2 m. 1.5 m of it are in the fixed block; 0.5 m and the plate are in the block that is pulled by
/// 0.2 m.
Scene frictionTube(PlateKind plate, double plateStrength) {
    Scene scene = twoBlocks(rigidRock, 1.5, 2.0);
    BoltType type = linearType(380e-6, 200e9);
    type.boltClass = BoltClass::CFC;
    type.anchors = {anchorRange(Per::Length, AnchorLaw::Frictional, 5e9, tubeFriction, 0.0)};
    type.plate.normalStrength = plateStrength;
    addBolt(scene, type, 0.0, 2.0, 60, plate);
    scene.stages = {pullStage(scene, 0.2, 100)};
    return scene;
}

double plateAtLargestForce(const Solved& solved) {
    const std::vector<double> force = series(solved, "joint force"), plate = series(solved, "plate");
    const auto most = std::max_element(force.begin(), force.end()) - force.begin();
    return force.empty() ? NAN : plate[most];
}

Solved solveWithPlateForce(Scene scene) {
    Monitor plate = scene.monitors.back();
    plate.name = "plate";
    plate.quantity = BoltQuantity::PlateForce;
    plate.at.reset();
    scene.monitors.push_back(plate);
    return solve(std::move(scene));
}

/// Once one side slides, the length that is still in its hole is the initial length minus the opening.
void strongPlate(Checks& checks) {
    const Solved solved = solveWithPlateForce(frictionTube(PlateKind::Spring, 89e3));
    checks.relative("plate 89 kN: largest force [N]", reading(solved, "max joint force"), 81.0e3, 1e-2);
    checks.relative("plate 89 kN: plate at that force [N]", plateAtLargestForce(solved), 54.0e3, 1e-2);
    checks.absolute("plate 89 kN: plates lost", countOf(solved, EventKind::PlateLoss), 0.0, 0.0);
    for (const double opening : {0.1, 0.15, 0.19})
        checks.relative("plate 89 kN: force at " + std::to_string(static_cast<int>(1e3 * opening + 0.5)) + " mm [N]",
                        loadAtOpening(loadPath(solved), opening), tubeFriction * (1.5 - opening), 1e-2);
}

void looseSide(Checks& checks, const Solved& solved, const std::string& which) {
    for (const double opening : {0.05, 0.1, 0.19})
        checks.relative(which + ": force at " + std::to_string(static_cast<int>(1e3 * opening + 0.5)) + " mm [N]",
                        loadAtOpening(loadPath(solved), opening), tubeFriction * (0.5 - opening), 1e-2);
}

std::vector<CaseResult> splitSet() {
    Checks checks("Split Set");
    strongPlate(checks);
    const Solved weak = solve(frictionTube(PlateKind::Spring, 40e3));
    checks.relative("plate 40 kN: force when the plate is lost [N]", reading(weak, "first plate-loss joint force"),
                    67.0e3, 1e-2);
    checks.absolute("plate 40 kN: plates lost", countOf(weak, EventKind::PlateLoss), 1.0, 0.0);
    looseSide(checks, weak, "plate 40 kN");
    const Solved bare = solve(frictionTube(PlateKind::None, 0.0));
    checks.relative("no plate: largest force [N]", reading(bare, "max joint force"), 27.0e3, 1e-2);
    looseSide(checks, bare, "no plate");
    return checks.take();
}

/// Force of the yielding anchor as a function of its slip [N]: 80 kN up to 600 mm, then rising to 100 kN at 700 mm.
double anchorForce(double slip, double stiffness) {
    if (slip < 80e3 / stiffness) return stiffness * slip;
    return slip < 0.6 ? 80e3 : 80e3 + 20e3 * (slip - 0.6) / 0.1;
}

Scene yieldingAnchor(double stiffness) {
    Scene scene = twoBlocks(rigidRock, 2.0, 2.5);
    BoltType type = linearType(123e-6, 200e9);
    type.boltClass = BoltClass::DFC;
    Anchor anchor = anchorAt(0.0, AnchorLaw::Curve, 0.0);
    anchor.curve = {{0.0, 0.0}, {80e3 / stiffness, 80e3}, {0.6, 80e3}, {0.7, 100e3}};
    type.anchors = {anchor};
    addBolt(scene, type, 0.3, 2.5, 44, PlateKind::Spring);
    scene.monitors.back().name = "force";
    Monitor slip = scene.monitors.back();
    slip.name = "slip";
    slip.quantity = BoltQuantity::Slip;
    slip.at = 0.0;
    scene.monitors.push_back(slip);
    scene.stages = {pullStage(scene, 0.65, 130)};
    return scene;
}

std::vector<CaseResult> roofex() {
    Checks checks("Roofex");
    const double stiffness = 100e6;
    const Solved solved = solve(yieldingAnchor(stiffness));
    const std::vector<double> slip = series(solved, "slip"), force = series(solved, "force");
    double worst = 0.0, most = 0.0;
    for (std::size_t i = 0; i < slip.size(); ++i) {
        const double u = std::abs(slip[i]);
        most = std::max(most, u);
        worst = std::max(worst, std::abs(force[i] - anchorForce(u, stiffness)) / 80e3);
    }
    checks.absolute("largest deviation from the curve, over 80 kN", slip.empty() ? NAN : worst, 0.0, 1e-2);
    const double stretch = 2.2 / (123e-6 * 200e9) + 1e-9;  // [m/N] compliance of the bar and the plate
    // At 0.65 m, the slip is u = 0.65 − stretch·F, on the rising part F = 80 kN + 200 kN/m·(u − 0.6).
    const double expected = (80e3 + 200e3 * 0.05) / (1.0 + 200e3 * stretch);
    checks.relative("force at an opening of 650 mm [N]", reading(solved, "last force"), expected, 1e-2);
    checks.relative("slip of the anchor [m]", most, 0.65 - stretch * expected, 1e-2);
    std::vector<std::pair<double, double>> path;
    const std::vector<double> opening = series(solved, "opening");
    for (std::size_t i = 0; i < opening.size(); ++i) path.emplace_back(opening[i], force[i]);
    checks.relative("force at 100 mm [N]", loadAtOpening(path, 0.1), 80e3, 1e-2);
    checks.relative("force at 600 mm [N]", loadAtOpening(path, 0.6), 80e3, 1e-2);
    return checks.take();
}

/// A block that falls at `speed` along +x is caught by a bar. The law of the bar's anchor in the fixed block is
/// `anchor`.
Scene caught(double mass, double speed, const Anchor& anchor, double duration) {
    Scene scene = emptyScene(rigidRock, 0.0, 0.0);
    scene.materials[0].second.density = mass;
    scene.blocks = {boxBlock("roof", {0, 0}, {1, 1}), boxBlock("load", {1.2, 0}, {2.2, 1})};
    Support support;
    support.blockAt = Point(0.5, 0.1);
    scene.supports = {support};
    scene.analysis.gravity = {gravity, 0.0};
    BoltType type = linearType(232e-6, 200e9);
    type.boltClass = BoltClass::DFC;
    type.bending = Bending::None;
    type.anchors = {anchor, anchorAt(1.2, AnchorLaw::Elastic, 1e12)};
    addBolt(scene, type, 0.1, 1.3, 12, PlateKind::None);
    scene.monitors.back().name = "slip";
    scene.monitors.back().quantity = BoltQuantity::Slip;
    scene.monitors.back().at = 0.0;
    Stage stage;
    stage.name = "catch";
    stage.kind = StageKind::Dynamic;
    stage.duration = duration;
    stage.timeStep = 1e-4;
    InitialVelocity initial;
    initial.blockAt = {1.7, 0.1};
    initial.velocity = {speed, 0.0};
    stage.initialVelocities = {initial};
    scene.stages = {stage};
    return scene;
}

double mostSlip(const Solved& solved) {
    double most = 0.0;
    for (const double slip : series(solved, "slip")) most = std::max(most, std::abs(slip));
    return solved.results.stages.empty() ? NAN : most;
}

/// ½·m·v² = (F − m·g)·slip: the kinetic energy plus the work of gravity during the slip equals the work of the constant
/// force F.
double slipOf(double mass, double speed, double force) { return 0.5 * mass * speed * speed / (force - mass * gravity); }

std::vector<CaseResult> constantSlip() {
    Checks checks("constant slip");
    Anchor anchor = anchorRange(Per::Node, AnchorLaw::Frictional, 1e9, 54e3, 0.0);
    anchor.at = BoltPlace{false, 0.0};
    checks.relative("1000 kg at 3 m/s against 54 kN: slip of the anchor [m]",
                    mostSlip(solve(caught(1000.0, 3.0, anchor, 0.12))), slipOf(1000.0, 3.0, 54e3), 2e-2);
    return checks.take();
}

std::vector<CaseResult> coneBoltDrop() {
    Checks checks("cone bolt");
    const double mass = 1115.0, speed = std::sqrt(2.0 * gravity * 1.5);
    for (const double force : {78.45e3, 88.26e3, 98.07e3}) {
        Anchor cone = anchorAt(0.0, AnchorLaw::Curve, 0.0);
        cone.curve = {{0.0, 0.0}, {force / 1e9, force}, {1.0, force}};
        checks.relative("1115 kg from 1.5 m, plough " + std::to_string(static_cast<int>(force / 10.0 + 0.5) * 10) +
                            " N: slip of the cone [m]",
                        mostSlip(solve(caught(mass, speed, cone, 0.15))), slipOf(mass, speed, force), 2e-2);
    }
    return checks.take();
}

}  // namespace

std::vector<Case> slidingBoltCases() {
    return {{"Split Set", "A friction tube with a strong plate, a weak plate and none.", splitSet},
            {"constant slip", "A falling block is caught by an anchor of constant force.", constantSlip},
            {"cone bolt", "A ploughing cone stops a weight that falls from 1.5 m.", coneBoltDrop},
            {"Roofex", "A bar that slips through its anchor and is stopped at 600 mm.", roofex}};
}

}  // namespace keyblock
