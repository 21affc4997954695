// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/edit/run_setup.h"

#include "ui/edit/defaults.h"

namespace keyblock {

namespace {

void addStages(Edit& edit) {
    std::vector<Stage>& stages = edit.scene.stages;
    stages = newScene().stages;
    for (const SceneTunnel& tunnel : edit.scene.tunnels) stages.back().excavate.push_back(tunnel.name);
    edit.notes.push_back("The stages '" + stages.front().name + "' and '" + stages.back().name + "' were added.");
    for (const Bolt& bolt : edit.scene.bolts) installOnWall(edit, bolt);
}

}  // namespace

Edit withRunSetup(const Scene& scene) {
    Edit edit{scene};
    if (scene.domain && scene.supports.empty()) supportSides(edit);
    if (scene.stages.empty() && (scene.domain || !scene.blocks.empty())) addStages(edit);
    return edit;
}

}  // namespace keyblock
