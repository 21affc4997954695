// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/setup/mesh_check.h"

#include "solver/engine/setup/make_model.h"
#include "solver/scene/lookup.h"
#include "solver/scene/pointer.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace keyblock {
namespace {

std::string millimetres(double metres) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3g", metres * 1e3);
    std::string shown = text;
    std::replace(shown.begin(), shown.end(), ',', '.');
    return shown + " mm";
}

bool onNode(const BoltModel& bolt, double joint, double tolerance) {
    return std::any_of(bolt.s.begin(), bolt.s.end(), [&](double s) { return std::abs(s - joint) <= tolerance; });
}

/// Longest element that crosses or touches a joint; 0 without joints.
double longestAtJoints(const BoltModel& bolt) {
    double longest = 0.0;
    for (const BoltElement& element : bolt.elements)
        if (element.shears) longest = std::max(longest, element.length);
    return longest;
}

/// Anchors of the bolt that are named by their place and have a node there that is in no rock.
void checkAnchorNodes(const Scene& scene, std::size_t index, const BoltModel& bolt, std::vector<Problem>& problems) {
    const std::vector<Anchor>& anchors = anchorsOf(scene, scene.bolts[index]);
    for (std::size_t n = 0; n < bolt.s.size(); ++n) {
        const int entry = bolt.anchors[n].entry;
        if (!bolt.anchors[n].real || bolt.startBlock[n] >= 0 || !anchors[static_cast<std::size_t>(entry)].at) continue;
        const std::string place = boltPointer(scene, index);
        Problem problem;
        problem.severity = Severity::Warning;
        problem.pointer = scene.bolts[index].anchors
                              ? under(under(under(place, "anchors"), static_cast<std::size_t>(entry)), "at")
                              : under(place, "type");
        problem.message = "the anchor of bolt " + bolt.name + " at " + millimetres(bolt.s[n]) +
                          " from its far end lies on a joint, in a gap or outside the rock: it holds nothing there";
        problem.remedy = "move the anchor or the bolt, so that the anchor lies in a block";
        problems.push_back(std::move(problem));
    }
}

}  // namespace

std::vector<Problem> checkMeshes(const Scene& scene) {
    std::vector<Problem> problems;
    if (scene.blocks.empty()) return problems;
    const Model model = makeModel(scene);
    for (std::size_t i = 0; i < scene.bolts.size(); ++i) {
        const BoltModel& bolt = model.bolts[i];
        checkAnchorNodes(scene, i, bolt, problems);
        if (!scene.bolts[i].divisions || !bolt.bends) continue;
        const double fine = bolt.dowelLength / 8.0, longest = longestAtJoints(bolt);
        const bool node = std::any_of(bolt.joints.begin(), bolt.joints.end(),
                                      [&](double joint) { return onNode(bolt, joint, model.tolerance); });
        if (longest <= fine * (1.0 + 1e-9) && !node) continue;
        Problem problem;
        problem.severity = Severity::Warning;
        problem.pointer = under(boltPointer(scene, i), "divisions");
        problem.message = "bolt " + bolt.name + " has " +
                          (longest > fine ? "elements of " + millimetres(longest) + " at a joint, where shear wants " +
                                                millimetres(fine) + " or less"
                                          : std::string("a node on a joint")) +
                          ": its dowel forces come out too soft; its pull is right";
        problem.remedy = "leave divisions out, and the program refines the bolt at every joint";
        problems.push_back(std::move(problem));
    }
    return problems;
}

}  // namespace keyblock
