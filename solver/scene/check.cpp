// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The order matters: the fields are checked first, then the rock, because later
// checks look up points only in blocks without errors.
#include "solver/scene/check.h"

#include "solver/scene/check_report.h"
#include "solver/scene/lookup.h"
#include "solver/scene/pointer.h"
#include "solver/scene/scene_cut.h"

#include <algorithm>

namespace keyblock {

std::vector<Problem> checkValues(const Scene& scene) {
    CheckReport report;
    checkFields(sceneStructure(), &scene, "", report);
    return std::move(report.problems);
}

namespace {

/// Whether the section can be cut: false if the data that define the cut have errors.
bool mayCut(const CheckReport& report) {
    constexpr std::string_view parts[] = {"/domain", "/cutting", "/joints", "/joint_sets", "/voronoi", "/regions",
                                          "/tunnels", "/bolt_patterns", "/materials", "/joint_materials"};
    return std::none_of(report.problems.begin(), report.problems.end(), [&](const Problem& problem) {
        return problem.severity == Severity::Error &&
               std::any_of(std::begin(parts), std::end(parts),
                           [&](std::string_view part) { return isWithin(problem.pointer, part); });
    });
}

bool hasSection(const Scene& scene) {
    return scene.domain || scene.voronoi || !scene.joints.empty() || !scene.jointSets.empty() ||
           !scene.regions.empty() || !scene.tunnels.empty() || !scene.boltPatterns.empty();
}

}  // namespace

std::vector<Problem> checkScene(const Scene& document, std::optional<SceneCut>* made, const std::atomic<bool>* stop) {
    CheckReport report;
    checkFields(sceneStructure(), &document, "", report);
    std::optional<SceneCut> cut;
    bool isCut = !needsCut(document);
    if (hasSection(document)) {
        CheckContext context{document, geometricTolerance(document), {}, {}, document, false, report};
        checkSection(context);
        if (!isCut && mayCut(report)) cut = cutScene(document, stop);
        isCut = isCut || cut;
    }
    const Scene& scene = cut ? cut->scene : document;
    CheckContext context{scene, geometricTolerance(scene), {}, {}, document, isCut, report};
    for (const auto part :
         {checkRock, checkBoltTypes, checkBolts, checkBodies, checkStages, checkWatch, checkStiffness})
        if ((!stop || !*stop) && !report.isFull()) part(context);
    if (made) *made = std::move(cut);
    return std::move(report.problems);
}

}  // namespace keyblock
