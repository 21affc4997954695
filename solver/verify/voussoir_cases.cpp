// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A voussoir beam: a slab that has cracked at mid-span and at both abutments
// and is stable as an arch. Equilibrium is checked with a tight tolerance, and
// the thrust is checked against an independent finite-element analysis. The
// rule in textbooks gives nearly twice that thrust, because it assumes a depth
// of contact instead of computing it (theory, "Voussoir beam"). It is evaluated
// here for comparison.
#include "solver/verify/checks.h"
#include "solver/verify/groups.h"
#include "solver/verify/readings.h"
#include "solver/verify/references.h"
#include "solver/verify/scenes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace keyblock {

namespace {

constexpr double span = 10.0, depth = 0.5;  // [m]
constexpr double beamModulus = 10e9;  // [Pa]
constexpr double beamWeight = 25e3;  // [N/m³]

/// γ·t·s²/8: the moment that thrust × arm must balance [N m].
double momentOf(double weight) { return weight * depth * span * span / 8.0; }

void addWall(Scene& scene, const std::string& name, double from, const std::string& joint) {
    Block wall = boxBlock(name, {from, -depth}, {from + 1.0, 2.0 * depth});
    wall.material = "wall";
    wall.jointMaterial = joint;
    scene.blocks.push_back(wall);
    Support support;
    support.blockAt = Point(from + 0.5, 0.0);
    scene.supports.push_back(support);
}

void addHalf(Scene& scene, const std::string& name, double from, int rows) {
    Block half = boxBlock(name, {from, 0.0}, {from + 0.5 * span, depth});
    half.subBlocks = CellSettings{depth / rows};
    scene.blocks.push_back(half);
}

/// Half of a beam between an abutment with friction and a smooth wall that replaces the mirror image, or the whole
/// beam. \param weight unit weight [N/m³]
Scene beamScene(int rows, double weight, bool whole) {
    Scene scene = emptyScene(beamModulus, 0.25, 60.0);
    scene.analysis.gravity = {0.0, -gravity};
    scene.analysis.tolerance = 1e-8;  // as tight as round-off in the bonds between cells permits
    scene.materials[0].second.density = weight / gravity;
    scene.materials.push_back({"wall", {2700.0, rigidRock, 0.25}});
    JointMaterial smooth;
    smooth.frictionAngle = 0.0;
    scene.jointMaterials.emplace_back("smooth", smooth);
    addWall(scene, "abutment", -1.0, "joint");
    addHalf(scene, "left", 0.0, rows);
    if (whole) addHalf(scene, "right", 0.5 * span, rows);
    addWall(scene, whole ? "other abutment" : "mirror", whole ? span : 0.5 * span, whole ? "joint" : "smooth");
    Stage stage;
    stage.name = "gravity";
    stage.until.unbalanced = 1e-8;
    scene.stages = {stage};
    return scene;
}

/// Force through the contacts at a face: its sum [N] and the height at which it acts [m].
struct FaceForce {
    double thrust = 0.0, height = 0.0;
};

FaceForce throughFace(const Frame& frame, double x) {
    FaceForce force;
    for (const ContactFrame& contact : frame.contacts) {
        if (std::abs(contact.position.x() - x) > 0.1 * span) continue;
        force.thrust += contact.normalForce;
        force.height += contact.normalForce * contact.position.y();
    }
    force.height /= force.thrust;
    return force;
}

struct Arch {
    double thrust = 0.0, arm = 0.0;  // [N], [m]
};

Arch archOf(const Scene& scene) {
    const Results results = solve(scene).results;
    if (results.frames.empty() || results.stages.back().outcome != Outcome::Equilibrium)
        return {std::nan(""), std::nan("")};
    const FaceForce abutment = throughFace(results.frames.back(), 0.0);
    const FaceForce middle = throughFace(results.frames.back(), 0.5 * span);
    return {middle.thrust, middle.height - abutment.height};
}

/// Thrust according to the textbook rule (Brady and Brown). Contact extends over a fraction n of the depth, and the
/// stress decreases from f to 0. The thrust is ½f·n·t, and the arm is t·(1 − 2n/3) minus the effect of the shortening
/// of the arch. The rule takes the n for which f is smallest.
double thrustByRule() {
    const auto archFor = [](double n) {
        const double first = depth * (1.0 - 2.0 * n / 3.0), rise = 8.0 * first * first / (3.0 * span);
        double arm = first;
        for (int round = 0; round < 200; ++round) {
            const double most = momentOf(beamWeight) / (0.5 * n * depth * arm);
            const double shortening = (span + rise) * 0.5 * most * (2.0 / 3.0 + 0.5 * n) / beamModulus;
            arm = std::sqrt(3.0 * span / 8.0 * std::max(0.0, rise - shortening));
        }
        return std::array{momentOf(beamWeight) / (0.5 * n * depth * arm), momentOf(beamWeight) / arm};
    };
    std::array<double, 2> least{INFINITY, std::nan("")};
    for (int i = 1; i < 1000; ++i) least = std::min(least, archFor(i / 1000.0));
    return least[1];
}

/// Cells of size h resolve the contact in steps of h, so the error of the arm is up to ½·h and the relative error of
/// the thrust up to ½·h/arm.
double resolved(int rows) { return 0.5 * depth / rows / voussoirReference.arm; }

std::vector<CaseResult> voussoirBeam() {
    Checks checks("voussoir beam");
    for (const int rows : {4, 8, 16}) {
        // a tenth of the weight, so that the sag, which increases the thrust, is only a thousandth of the arm
        const double share = 0.1;
        const Arch arch = archOf(beamScene(rows, share * beamWeight, false));
        checks.relative("thrust over weight, " + std::to_string(rows) + " rows of cells, on the reference's",
                        arch.thrust / share / voussoirReference.thrust, 1.0, resolved(rows));
    }
    const Arch arch = archOf(beamScene(4, beamWeight, true));
    checks.relative("thrust × arm over γts²/8, at equilibrium", arch.thrust * arch.arm / momentOf(beamWeight), 1.0, 1e-3);
    checks.relative("thrust at equilibrium, 4 rows of cells [N]", arch.thrust, voussoirReference.thrust, resolved(4));
    checks.relative("for comparison: Brady and Brown's rule [N]", thrustByRule(), 621e3, 5e-3);
    return checks.take();
}

}  // namespace

std::vector<Case> voussoirCases() {
    return {{"voussoir beam", "A cracked slab is stable as an arch between its abutments.", voussoirBeam}};
}

}  // namespace keyblock
