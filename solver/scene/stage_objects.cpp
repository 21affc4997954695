// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/scene/stage_objects.h"

#include "solver/scene/lookup.h"

#include <algorithm>

namespace keyblock {
namespace {

bool contains(const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

/// Name of the pattern that the bolt belongs to; null for an individual bolt.
const std::string* patternOf(const Scene& scene, const Bolt& bolt) {
    return bolt.pattern < 0 ? nullptr : &scene.boltPatterns[bolt.pattern].name;
}

}  // namespace

std::vector<int> excavatedBlocks(const Scene& scene, const Stage& stage) {
    std::vector<int> blocks;
    for (int block = 0; !stage.excavate.empty() && block < static_cast<int>(scene.blocks.size()); ++block) {
        const std::vector<int>& tunnels = scene.blocks[block].tunnels;
        const bool inTunnel = std::any_of(tunnels.begin(), tunnels.end(), [&](int tunnel) {
            return contains(stage.excavate, scene.tunnels[tunnel].name);
        });
        if (inTunnel || contains(stage.excavate, displayName(scene, block))) blocks.push_back(block);
    }
    return blocks;
}

std::vector<int> boltsNamed(const Scene& scene, const std::string& name) {
    std::vector<int> found;
    for (std::size_t i = 0; i < scene.bolts.size(); ++i) {
        const std::string* pattern = patternOf(scene, scene.bolts[i]);
        if (scene.bolts[i].name == name || (pattern && *pattern == name)) found.push_back(static_cast<int>(i));
    }
    return found;
}

bool isInstalledLater(const Scene& scene, const Bolt& bolt) {
    return std::any_of(scene.stages.begin(), scene.stages.end(), [&](const Stage& stage) {
        const std::string* pattern = patternOf(scene, bolt);
        return contains(stage.install, bolt.name) || (pattern && contains(stage.install, *pattern));
    });
}

Stress inSituStressAt(const Scene& scene, const Point& place) {
    if (!scene.inSituStress) return {0.0, 0.0, 0.0};
    const InSituStress& stress = *scene.inSituStress;
    const double above = place.y() - stress.referenceY;
    const StressGradient& change = stress.gradientY;
    return {stress.sxx + change.sxx * above, stress.syy + change.syy * above, stress.sxy + change.sxy * above};
}

}  // namespace keyblock
