// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The order in which parts fail, and the forces at which they fail, must not
// depend on the size of the increments: each scene is run with its own
// increments, and with twice and four times as many.
#include "solver/verify/checks.h"
#include "solver/verify/groups.h"
#include "solver/verify/paper_steel.h"
#include "solver/verify/readings.h"
#include "solver/verify/scenes.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace keyblock {

namespace {

/// A smooth bar with a cone that starts to plough at 78.45 kN and a plate that fails at 90 kN.
Scene coneBolt(int increments) {
    Scene scene = twoBlocks(rigidRock, 1.5, 2.3);
    BoltType type = linearType(232e-6, 200e9);
    type.boltClass = BoltClass::DFC;
    Anchor cone = anchorAt(0.0, AnchorLaw::Curve, 0.0);
    cone.curve = {{0.0, 0.0}, {78.45e3 / 50e6, 78.45e3}, {0.2, 98.07e3}};
    type.anchors = {cone};
    type.plate.normalStrength = 90e3;
    addBolt(scene, type, 0.0, 2.3, 46, PlateKind::Spring);
    scene.stages = {pullStage(scene, 0.15, increments)};
    return scene;
}

void compareWithWhole(Checks& checks, const std::string& what, const std::vector<Release>& whole,
                      const std::vector<Release>& finer) {
    const bool alike = whole.size() == finer.size() && !whole.empty();
    std::size_t same = 0;
    double load = alike ? 0.0 : NAN;
    for (std::size_t i = 0; i < std::min(whole.size(), finer.size()); ++i) {
        if (whole[i].kind == finer[i].kind && whole[i].index == finer[i].index) ++same;
        load = std::max(load, std::abs(finer[i].load / whole[i].load - 1.0));
    }
    checks.absolute(what + ": identical releases", alike ? static_cast<double>(same) : NAN,
                    static_cast<double>(whole.size()), 0.0);
    checks.absolute(what + ": largest relative difference of force", alike ? load : NAN, 0.0, 1e-3);
}

void compareSteps(Checks& checks, const std::string& what, int increments, const std::function<Scene(int)>& scene) {
    const std::vector<Release> whole = releases(solve(scene(increments)));
    compareWithWhole(checks, what + ", half step", whole, releases(solve(scene(2 * increments))));
    compareWithWhole(checks, what + ", quarter step", whole, releases(solve(scene(4 * increments))));
}

std::vector<CaseResult> stepIndependence() {
    Checks checks("step independence");
    compareSteps(checks, "rebar", 20,
                 [](int n) { return paperRebar(213.043e9, 24.56e3, 59, rigidRock, 4e-3, n); });
    compareSteps(checks, "D-bolt", 40,
                 [](int n) { return paperDBolt(textSteel, PlateKind::Spring, rigidRock, 0.14, n); });
    compareSteps(checks, "cone bolt", 15, coneBolt);
    return checks.take();
}

}  // namespace

std::vector<Case> stepCases() {
    return {{"step independence", "The same releases with the full, half and quarter time step.", stepIndependence}};
}

}  // namespace keyblock
