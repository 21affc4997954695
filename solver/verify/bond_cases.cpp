// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bonds along a bolt that crosses one joint: elastic, slipping and brittle.
#include "solver/verify/checks.h"
#include "solver/verify/groups.h"
#include "solver/verify/readings.h"
#include "solver/verify/references.h"
#include "solver/verify/scenes.h"

#include <algorithm>
#include <cmath>

namespace keyblock {

namespace {

constexpr double lagBond = 254.34e6;  // [N/m per m]
constexpr double rigidPlate = 1e13;  // [N/m]

Monitor boltForce(const std::string& name, double at) {
    Monitor monitor;
    monitor.name = name;
    monitor.bolt = "B";
    monitor.at = at;
    return monitor;
}

/// A bolt of 20 mm diameter under 200 kN. On each side of the joint it is divided into `perSide` intervals, each with a
/// spring in its middle as the bond.
Scene shearLag(int perSide) {
    Scene scene = twoBlocks(rigidRock, 1.0, 2.0);
    const double h = 1.0 / perSide;
    BoltType type = linearType(barArea(), 200e9);
    type.anchors = {anchorRange(Per::Node, AnchorLaw::Elastic, lagBond * h, std::nullopt, 0.0)};
    addBolt(scene, type, 0.5 * h, 2.0 - 0.5 * h, 2 * perSide - 1, PlateKind::None);
    scene.monitors.push_back(boltForce("quarter", 1.25 - 0.5 * h));
    scene.monitors.push_back(boltForce("half", 1.5 - 0.5 * h));
    scene.stages = {loadStage(scene, 200e3, 2)};
    return scene;
}

/// The same bond, given per unit length. The load is only 2 kN, so that the length that slips out of the hole is negligible.
Scene plateLag(int divisions, PlateKind plate) {
    Scene scene = twoBlocks(rigidRock, 1.0, 2.0);
    BoltType type = linearType(barArea(), 200e9);
    type.anchors = {anchorRange(Per::Length, AnchorLaw::Elastic, lagBond, std::nullopt, 0.0)};
    type.plate.normalStiffness = rigidPlate;
    addBolt(scene, type, 0.0, 2.0, divisions, plate);
    scene.stages = {loadStage(scene, 2e3, 2)};
    return scene;
}

/// Continuum solution: with λ² = k/EA, the axial force is N(x) = P·sinh λ(1 − x)/sinh λ, and the slip at the joint is
/// P/(EAλ·tanh λ). A rigid plate carries P/cosh λ and reduces the slip to P·tanh λ/(EAλ).
std::vector<CaseResult> elasticPull() {
    Checks checks("shear lag");
    std::vector<double> errors;
    for (const ShearLagReference& r : shearLagReferences) {
        const Solved solved = solve(shearLag(r.perSide));
        const std::string with = ", " + std::to_string(r.perSide) + " springs a side";
        const double slip = 0.5 * reading(solved, "last opening");
        checks.relative("slip at the joint" + with + " [m]", slip, r.slip, 1e-3);
        checks.relative("force at 0.25 m" + with + " [N]", reading(solved, "last quarter"), r.quarter, 1e-3);
        checks.relative("force at 0.5 m" + with + " [N]", reading(solved, "last half"), r.half, 1e-3);
        errors.push_back(slip);
    }
    checks.relative("order of convergence", std::log2((errors[0] - errors[1]) / (errors[1] - errors[2])), 2.0, 0.05);
    checks.relative("extrapolated slip [m]", errors[2] + (errors[2] - errors[1]) / 3.0, 1.6397e-3, 1e-3);
    for (const PlateLagReference& r : plateLagReferences) {
        const Solved without = solve(plateLag(r.divisions, PlateKind::None));
        const Solved with = solve(plateLag(r.divisions, PlateKind::Spring));
        const std::string on = ", by length on " + std::to_string(r.divisions) + " divisions";
        checks.relative("opening" + on + " [m]", reading(without, "last opening"), r.openingWithout, 1e-3);
        checks.relative("opening with a plate" + on + " [m]", reading(with, "last opening"), r.openingWith, 1e-3);
        checks.relative("plate" + on + " [N]", reading(with, "last B.plate_force"), r.plate, 1e-3);
    }
    return checks.take();
}

std::vector<int> nodesOf(const std::vector<ReferenceRelease>& list) {
    std::vector<int> nodes;
    for (const ReferenceRelease& r : list) nodes.push_back(r.node);
    return nodes;
}

std::vector<CaseResult> brittle() {
    Checks checks("brittle debonding");
    const Solved solved = solve(paperRebar(200e9, 24.56e3, 59, rigidRock, 5e-3, 50));
    const std::vector<Release> found = releases(solved);
    const std::vector<ReferenceRelease>& expected = brittleDebonding;
    const double count = static_cast<double>(expected.size());
    checks.absolute("releases", static_cast<double>(found.size()), count, 0.0);
    checks.absolute("releases in the reference's order", agreeing(found, nodesOf(expected)), count, 0.0);
    const Release none{EventKind::Debonding, -1, NAN, NAN};
    const Release first = found.empty() ? none : found.front(), last = found.empty() ? none : found.back();
    checks.relative("first release [N]", first.load, 128.735e3, 1e-3);
    checks.relative("first release [m]", first.opening, 0.6477e-3, 5e-3);
    checks.relative("largest force [N]", reading(solved, "max joint force"), 169.572e3, 1e-3);
    checks.relative("last release [m]", last.opening, 3.9394e-3, 5e-3);
    checks.relative("residual force [N]", reading(solved, "last joint force"), 67.20e3, 1e-3);
    double load = found.size() == expected.size() ? 0.0 : NAN, opening = load;
    for (std::size_t i = 0; i < std::min(found.size(), expected.size()); ++i) {
        load = std::max(load, std::abs(found[i].load / expected[i].load - 1.0));
        opening = std::max(opening, std::abs(found[i].opening / expected[i].opening - 1.0));
    }
    checks.absolute("largest relative deviation of a release's force", load, 0.0, 1e-3);
    checks.absolute("largest relative deviation of a release's opening", opening, 0.0, 5e-3);
    return checks.take();
}

/// A long cable of stiffness EA with a perfectly plastic bond of strength q and stiffness k; u is the slip at the
/// collar, and λ² = k/EA. Slip starts at P = q/λ and u = q/k. From then on, P² = (q/λ)² + 2·EA·q·(u − q/k). The steel
/// breaks at 500 kN.
struct Cable {
    double area = 181e-6, modulus = 98.6e9, length = 17.7, bond = 112e6, strength = 0.175e6, breaks = 500e3;

    double stiffness() const { return area * modulus; }
    double slipStart() const { return strength / std::sqrt(bond / stiffness()); }
    double forceAt(double slip) const {
        return std::sqrt(slipStart() * slipStart() + 2.0 * stiffness() * strength * (slip - strength / bond));
    }
    double slipAt(double force) const {
        return strength / bond + (force * force - slipStart() * slipStart()) / (2.0 * stiffness() * strength);
    }
};

/// The collar lies 1.5 divisions inside the fixed block, so that the cable that slips out of the grout is still in
/// rock. A rigid plate supports the head, which lies two divisions beyond the collar.
Scene groutedCable(const Cable& cable, int divisions) {
    const double h = cable.length / divisions;
    Scene scene = twoBlocks(rigidRock, cable.length + 1.5 * h, cable.length + 3.0 * h);
    const double strain = cable.breaks / cable.stiffness();
    BoltType type = steelType(cable.area, {{0.0, 0.0}, {strain, cable.breaks / cable.area}});
    Anchor bond = anchorRange(Per::Length, AnchorLaw::Frictional, cable.bond, cable.strength, 0.0);
    bond.to = {false, cable.length};
    type.anchors = {bond};
    type.plate.normalStiffness = rigidPlate;
    addBolt(scene, type, 0.0, cable.length + 2.0 * h, divisions + 2, PlateKind::Spring);
    Monitor collar = scene.monitors.back();
    collar.name = "collar";
    collar.quantity = BoltQuantity::Slip;
    collar.at = cable.length;
    scene.monitors.push_back(collar);
    scene.stages = {pullStage(scene, 50e-3, 100)};
    return scene;
}

/// Slip at the collar and force in the cable for every row of the history.
std::vector<std::pair<double, double>> collarPath(const Solved& solved) {
    const std::vector<double> slip = series(solved, "collar"), force = series(solved, "joint force");
    std::vector<std::pair<double, double>> path;
    for (std::size_t i = 0; i < slip.size(); ++i) path.emplace_back(std::abs(slip[i]), force[i]);
    return path;
}

/// Number of releases at the beginning of the list that are those of nodes `first`, `first` − 1, … in this order.
int slipsInwards(const std::vector<Release>& found, int first) {
    int slipped = 0;
    for (const Release& release : found) {
        if (release.kind != EventKind::Debonding || release.index != first - slipped) break;
        ++slipped;
    }
    return slipped;
}

std::vector<CaseResult> cablePull() {
    Checks checks("grouted cable");
    const Cable cable;
    const Solved solved = solve(groutedCable(cable, 200));
    const std::vector<Release> found = releases(solved);
    checks.relative("force when slip starts [N]", reading(solved, "first debonding joint force"), 69.86e3, 1e-2);
    checks.relative("collar when slip starts [m]", std::abs(reading(solved, "first debonding collar")), 1.5625e-3,
                    1e-2);
    checks.relative("force at 30 mm [N]", loadAtOpening(collarPath(solved), 30e-3), cable.forceAt(30e-3), 1e-2);
    checks.relative("force at rupture [N]", reading(solved, "first tensile-rupture joint force"), cable.breaks, 1e-2);
    checks.relative("collar at rupture [m]", std::abs(reading(solved, "first tensile-rupture collar")),
                    cable.slipAt(cable.breaks), 1e-2);
    checks.absolute("nodes that slip in order from the collar inwards", slipsInwards(found, 200),
                    countOf(solved, EventKind::Debonding), 0.0);
    return checks.take();
}

}  // namespace

std::vector<Case> bondCases() {
    return {{"shear lag", "An elastic bond under a pull, with and without a rigid plate.", elasticPull},
            {"brittle debonding", "A bond that breaks node by node, release by release.", brittle},
            {"grouted cable", "A perfectly plastic bond until the cable breaks.", cablePull}};
}

}  // namespace keyblock
