// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/setup/mesh_check.h"

#include "solver/engine/bolt/bolt_mesh.h"
#include "solver/engine/setup/make_model.h"
#include "solver/scene/lookup.h"
#include "solver/scene/pointer.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace keyblock {
namespace {

constexpr double largestOpening = 0.02;  // too far, as a fraction, where a node lies on a joint
constexpr double largestShare = 0.3;  // of the transfer length: a pull then opens the joint 1 % too far

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

/// Length of the longest element that crosses or touches a joint; 0 without joints.
double longestAtJoints(const BoltModel& bolt) {
    double longest = 0.0;
    for (const BoltElement& element : bolt.elements)
        if (element.shears) longest = std::max(longest, element.length);
    return longest;
}

/// Warns of anchors that are given by their position and whose node there is not in rock.
void checkAnchorNodes(const Scene& scene, std::size_t index, const BoltModel& bolt, std::vector<Problem>& problems) {
    const std::vector<Anchor>& anchors = anchorsOf(scene, scene.bolts[index]);
    for (std::size_t n = 0; n < bolt.s.size(); ++n) {
        const int entry = bolt.anchors[n].entry;
        if (!bolt.anchors[n].real || bolt.startBlock[n] >= 0 || !anchors[entry].at) continue;
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

/// Element length and transfer length √(EA/k) where their ratio is largest, at joints with a bond per metre. Anchors
/// per node have no transfer length of their own, because the number of nodes is part of their law.
struct BondMesh {
    double element = 0.0, transfer = 0.0;  // [m]
    bool onNode = false;  // a node lies on the joint, so that the bar is free over two elements

    double share() const { return transfer > 0.0 ? element / transfer : 0.0; }
    /// Excess of the opening under a pull, as a fraction.
    double opens() const {
        const double x = share();
        return std::sqrt(1.0 + 0.25 * x * x) - 1.0 + (onNode ? 0.5 * x : 0.0);
    }
};

BondMesh bondMeshOf(const BoltModel& bolt, double tolerance) {
    BondMesh worst;
    const double axial = bolt.section.youngsModulus * bolt.section.area;
    for (std::size_t e = 0; e < bolt.elements.size(); ++e)
        for (const std::size_t n : {e, e + 1}) {
            const AnchorModel& anchor = bolt.anchors[n];
            const double stiffness = anchor.curve ? anchor.curve->modulus : anchor.stiffness;
            if (!bolt.elements[e].shears || !anchor.real || anchor.per != Per::Length || stiffness <= 0.0) continue;
            const bool node = std::any_of(bolt.joints.begin(), bolt.joints.end(), [&](double joint) {
                return std::min(std::abs(bolt.s[e] - joint), std::abs(bolt.s[e + 1] - joint)) <= tolerance;
            });
            const BondMesh here{bolt.elements[e].length, std::sqrt(axial / stiffness), node};
            if (here.opens() > worst.opens()) worst = here;
        }
    return worst;
}

std::string percent(double share) {
    char text[32];
    std::snprintf(text, sizeof text, share < 0.1 ? "%.1f" : "%.0f", 100.0 * share);
    return text + std::string(" %");
}

/// Warns of elements that are too long for the bond. The errors are those of an infinite bar with springs at every node
/// and a joint in the middle of an element, compared with a continuous bond (theory, "Divisions").
void checkBond(const Scene& scene, std::size_t index, const BoltModel& bolt, double tolerance,
               std::vector<Problem>& problems) {
    const BondMesh mesh = bondMeshOf(bolt, tolerance);
    const double x = mesh.share(), opens = mesh.opens();
    if (x <= largestShare && !(mesh.onNode && opens > largestOpening)) return;
    const double lasts = std::expm1(2.0 * std::asinh(0.5 * x)) / x - 1.0;
    const double wanted = std::ceil(bolt.s.back() / (0.25 * mesh.transfer));
    const bool possible = wanted <= 1e5;
    Problem problem;
    problem.severity = Severity::Warning;
    problem.pointer = under(boltPointer(scene, index), "divisions");
    problem.message = "bolt " + bolt.name + " has elements of " + millimetres(mesh.element) + " at a joint" +
                      (mesh.onNode ? ", on which a node lies, " : ", ") + percent(x) + " of the " +
                      millimetres(mesh.transfer) +
                      " over which its bond takes up a force: under a pull the joint opens " + percent(opens) +
                      " too far, and a bond with a peak strength fails at a load " + percent(lasts) + " too high";
    problem.remedy = scene.bolts[index].divisions
                         ? "leave divisions out" +
                               (possible ? ", or give at least " + std::to_string(static_cast<int>(wanted)) : "")
                         : "shorten the bolt: an automatic mesh has at most about " + std::to_string(mostElements) +
                               " elements";
    problems.push_back(std::move(problem));
}

/// Warns of a range of anchors with a strength per node and automatic divisions: the number of nodes then determines
/// the total strength.
void checkAnchorCount(const Scene& scene, std::size_t index, const BoltModel& bolt, std::vector<Problem>& problems) {
    if (scene.bolts[index].divisions) return;
    const std::vector<Anchor>& anchors = anchorsOf(scene, scene.bolts[index]);
    for (std::size_t entry = 0; entry < anchors.size(); ++entry) {
        if (anchors[entry].at || anchors[entry].per != Per::Node) continue;
        const auto nodes = std::count_if(bolt.anchors.begin(), bolt.anchors.end(), [&](const AnchorModel& anchor) {
            return anchor.real && anchor.entry == static_cast<int>(entry);
        });
        const std::string place = boltPointer(scene, index);
        Problem problem;
        problem.severity = Severity::Warning;
        problem.pointer = under(place, "divisions");
        problem.message = "the bond of bolt " + bolt.name + " is given for each node, and its automatic divisions make " +
                          std::to_string(nodes) + " of them: its strength depends on that number";
        problem.remedy = "give the divisions for which the anchors were measured, or give the bond per metre";
        problems.push_back(std::move(problem));
    }
}

/// Warns of given divisions that are too coarse for a dowel or that put a node on a joint.
void checkDowel(const Scene& scene, std::size_t index, const BoltModel& bolt, double tolerance,
                std::vector<Problem>& problems) {
    if (!scene.bolts[index].divisions || !bolt.bends || !bolt.shears) return;
    const double fine = bolt.dowelLength / 8.0, longest = longestAtJoints(bolt);
    const bool node = std::any_of(bolt.joints.begin(), bolt.joints.end(),
                                  [&](double joint) { return onNode(bolt, joint, tolerance); });
    if (longest <= fine * (1.0 + 1e-9) && !node) return;
    Problem problem;
    problem.severity = Severity::Warning;
    problem.pointer = under(boltPointer(scene, index), "divisions");
    problem.message = "bolt " + bolt.name + " has " +
                      (longest > fine ? "elements of " + millimetres(longest) + " at a joint, where shear requires " +
                                            millimetres(fine) + " or less"
                                      : std::string("a node on a joint")) +
                      ": its dowel forces come out too soft";
    problem.remedy = "leave divisions out, and the program refines the bolt at every joint";
    problems.push_back(std::move(problem));
}

}  // namespace

std::vector<Problem> checkMeshes(const Scene& scene) {
    std::vector<Problem> problems;
    if (scene.blocks.empty()) return problems;
    const Model model = makeModel(scene);
    for (std::size_t i = 0; i < scene.bolts.size(); ++i) {
        checkAnchorNodes(scene, i, model.bolts[i], problems);
        checkBond(scene, i, model.bolts[i], model.tolerance, problems);
        checkAnchorCount(scene, i, model.bolts[i], problems);
        checkDowel(scene, i, model.bolts[i], model.tolerance, problems);
    }
    return problems;
}

}  // namespace keyblock
