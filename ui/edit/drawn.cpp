// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/edit/drawn.h"

#include "geometry/shape/joint_set.h"
#include "solver/scene/lookup.h"
#include "solver/scene/shapes.h"
#include "ui/edit/appended.h"
#include "ui/edit/defaults.h"

#include <algorithm>

namespace keyblock {
namespace {

constexpr const char* noStage = "There is no stage yet. Add a stage first.";

bool usable(const std::vector<Point>& points) { return std::all_of(points.begin(), points.end(), isUsable); }

/// Adds an item to a list of a stage.
template <typename Item>
Edit intoStage(const Scene& scene, std::size_t stage, std::vector<Item> Stage::*list, const char* key, const Item& item) {
    if (stage >= scene.stages.size()) return {scene, noStage};
    Edit edit{scene};
    std::vector<Item>& items = edit.scene.stages[stage].*list;
    items.push_back(item);
    edit.made = under(under(under("/stages", stage), key), items.size() - 1);
    return edit;
}

}  // namespace

Edit withBlock(const Scene& scene, const Block& block) {
    if (std::string problem = outlineProblem(block.points); !problem.empty()) return {scene, problem};
    Block made = block;
    if (made.material.empty()) made.material = firstMaterial(scene);
    return appended(scene, &Scene::blocks, "/blocks", made);
}

Edit withRegion(const Scene& scene, const SceneRegion& region) {
    if (std::string problem = outlineProblem(region.points); !problem.empty()) return {scene, problem};
    return appended(scene, &Scene::regions, "/regions", region);
}

Edit withJoint(const Scene& scene, const SceneJoint& joint) {
    if (joint.points.size() < 2 || !usable(joint.points)) return {scene, "A joint needs at least two points."};
    if (!scene.domain) return {scene, "There is no rock to cut yet. Draw the outline first."};
    return appended(scene, &Scene::joints, "/joints", joint);
}

Edit withJointSet(const Scene& scene, const SceneJointSet& set) {
    if (const auto problem = jointSetProblem(jointSetOf(set)))
        return {scene, "The set cannot be drawn: " + problem->message + "."};
    if (!scene.domain) return {scene, "There is no rock to cut yet. Draw the outline first."};
    return appended(scene, &Scene::jointSets, "/joint_sets", set);
}

Edit withMonitor(const Scene& scene, const Monitor& monitor) {
    return appended(scene, &Scene::monitors, "/monitors", monitor);
}

Edit withSupport(const Scene& scene, const Support& support) {
    for (std::size_t i = 0; support.boundary && i < scene.supports.size(); ++i) {
        if (scene.supports[i].boundary != support.boundary) continue;
        Edit edit{scene};
        edit.scene.supports[i] = support;
        edit.made = under("/supports", i);
        return edit;
    }
    if (support.boundary && !scene.domain)
        return {scene, "There is no outline yet. Support a point or a block instead."};
    return appended(scene, &Scene::supports, "/supports", support);
}

Edit withLoad(const Scene& scene, std::size_t stage, const Load& load) {
    return intoStage(scene, stage, &Stage::loads, "loads", load);
}

Edit withMotion(const Scene& scene, std::size_t stage, const Motion& motion) {
    return intoStage(scene, stage, &Stage::motions, "motions", motion);
}

}  // namespace keyblock
