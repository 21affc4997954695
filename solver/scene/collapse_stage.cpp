// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/scene/collapse_stage.h"

#include <utility>

namespace keyblock {
namespace {

/// The dynamic stage after a collapse. It starts from rest, under the loads at collapse.
Stage motionAfter(const Stage& stage) {
    Stage motion;
    motion.name = nameOfCollapse(stage);
    motion.kind = StageKind::Dynamic;
    motion.duration = stage.collapseDuration;
    motion.continueAfterCollapse = stage.continueAfterCollapse;
    motion.until = stage.until;
    motion.followsCollapse = true;
    return motion;
}

}  // namespace

std::string nameOfCollapse(const Stage& stage) { return stage.name + " (collapse)"; }

Scene withCollapseStages(Scene scene) {
    std::vector<Stage> stages;
    for (Stage& stage : scene.stages) {
        const bool follows = stage.kind == StageKind::Static && std::exchange(stage.onCollapse, OnCollapse::End) == OnCollapse::Dynamic;
        stages.push_back(std::move(stage));
        if (follows) stages.push_back(motionAfter(stages.back()));
    }
    scene.stages = std::move(stages);
    return scene;
}

}  // namespace keyblock
