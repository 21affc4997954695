// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/scene/presence.h"

#include "solver/scene/lookup.h"

#include <algorithm>

namespace keyblock {

std::vector<int> excavatedBlocks(const Scene& scene, const Stage& stage) {
    std::vector<int> blocks;
    for (int block = 0; !stage.excavate.empty() && block < static_cast<int>(scene.blocks.size()); ++block)
        if (std::find(stage.excavate.begin(), stage.excavate.end(), displayName(scene, block)) != stage.excavate.end())
            blocks.push_back(block);
    return blocks;
}

int boltNamed(const Scene& scene, const std::string& name) {
    const auto found = std::find_if(scene.bolts.begin(), scene.bolts.end(),
                                    [&](const Bolt& bolt) { return bolt.name == name; });
    return found == scene.bolts.end() ? -1 : static_cast<int>(found - scene.bolts.begin());
}

bool isInstalledLater(const Scene& scene, const Bolt& bolt) {
    return std::any_of(scene.stages.begin(), scene.stages.end(), [&](const Stage& stage) {
        return std::find(stage.install.begin(), stage.install.end(), bolt.name) != stage.install.end();
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
