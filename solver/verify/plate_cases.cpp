// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A plate modelled as a block, held by contact, must carry the same force as a
// plate modelled by springs. The two differ only by the compliance of the
// contact penalty and of the plate's steel, both ten thousand times as stiff as
// the plate's springs.
#include "solver/verify/checks.h"
#include "solver/verify/groups.h"
#include "solver/verify/readings.h"
#include "solver/verify/scenes.h"

#include <cmath>
#include <string>

namespace keyblock {

namespace {

double plateForce(Scene scene, PlateKind kind) {
    scene.bolts.front().plate = kind;
    return reading(solve(scene), "last B.plate_force");
}

/// The paper's elastic rebar under 200 kN. The stiffer the bond, the less force reaches the plate.
void elasticRebars(Checks& checks) {
    const double bonds[] = {20e6, 84.78e6};
    for (const double bond : bonds) {
        const Scene scene = elasticRebar(bond, rigidRock);
        checks.relative(std::string("elastic rebar, k_s ") + (bond == 20e6 ? "20" : "84.78") +
                            " kN/mm: plate force over that of a spring",
                        plateForce(scene, PlateKind::Block) / plateForce(scene, PlateKind::Spring), 1.0, 1e-3);
    }
}

/// The head leaves a face at an angle. The plate lies on the face, and its normal force is the component of the bolt
/// force normal to the face.
void inclined(Checks& checks) {
    const double angle = std::atan2(0.3, 0.9);
    Scene scene = twoBlocks(rigidRock, 1.0, 2.0);
    BoltType type = linearType(barArea(), 200e9);
    type.bending = Bending::None;
    type.anchors = {anchorAt(0.0, AnchorLaw::Elastic, 1e12)};
    type.normalStiffness = 1e3;  // the transverse force is negligible except at the plate
    type.plate.normalStiffness = type.plate.shearStiffness = 1e9;
    addBolt(scene, type, 0.1, 2.0, 1, PlateKind::Block);
    scene.bolts.front().farEnd = {0.2, 0.3};
    scene.bolts.front().head = {2.0, 0.9};
    scene.jointMaterials.front().second.frictionAngle = 60.0;  // keeps the plate from sliding along the face
    Support rail;  // restricts the block to movement along x
    rail.point = Point(1.5, 0.0);
    rail.fix = Fix::Y;
    scene.supports.push_back(rail);
    scene.stages = {pullStage(scene, 1e-4, 1)};
    const Solved solved = solve(scene);
    const double axial = reading(solved, "last B.axial_force"), plate = reading(solved, "last B.plate_force");
    checks.relative("inclined bolt: plate force over the bolt's across the face", plate / (axial * std::cos(angle)), 1.0,
                    1e-3);
}

std::vector<CaseResult> plateAsBlock() {
    Checks checks("plate as a block");
    elasticRebars(checks);
    inclined(checks);
    return checks.take();
}

}  // namespace

std::vector<Case> plateCases() {
    return {{"plate as a block", "A plate that is a block carries what a plate of springs does.", plateAsBlock}};
}

}  // namespace keyblock
