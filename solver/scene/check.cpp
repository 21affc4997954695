// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The order matters: fields first, then rock, because places are looked up in
// blocks that are known to be sound.
#include "solver/scene/check.h"

#include "solver/scene/check_report.h"
#include "solver/scene/lookup.h"

namespace keyblock {

std::vector<Problem> checkValues(const Scene& scene) {
    CheckReport report;
    checkFields(sceneStructure(), &scene, "", report);
    return std::move(report.problems);
}

std::vector<Problem> checkScene(const Scene& scene) {
    CheckReport report;
    checkFields(sceneStructure(), &scene, "", report);
    CheckContext context{scene, geometricTolerance(scene), {}, {}, report};
    checkRock(context);
    checkBoltTypes(context);
    checkBolts(context);
    checkBodies(context);
    checkStages(context);
    checkWatch(context);
    return std::move(report.problems);
}

}  // namespace keyblock
