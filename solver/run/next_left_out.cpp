// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/run/next_left_out.h"

#include "solver/scene/bond_per_node.h"
#include "solver/scene/enum_names.h"
#include "solver/scene/lookup.h"
#include "solver/scene/preset.h"

#include <algorithm>

namespace keyblock {
namespace {

constexpr int fewElements = 30;  // of a bolt; fewer change most results
constexpr const char* notMeasured = "not measured; 'keyblock trade' measures it";

/// Of the bolts whose strength does not depend on their divisions.
int mostElements(const Scene& scene, const Model& model) {
    std::size_t most = 0;
    for (std::size_t b = 0; b < model.bolts.size(); ++b)
        if (!isGivenPerNode(anchorsOf(scene, scene.bolts[b]))) most = std::max(most, model.bolts[b].elements.size());
    return static_cast<int>(most);
}

std::string presetName(Preset preset) { return std::string(presetWords[static_cast<std::size_t>(preset)]); }

}  // namespace

std::vector<NextLeftOut> nextLeftOut(const Scene& scene, const Model& model) {
    std::vector<NextLeftOut> list;
    const auto add = [&](bool applies, const char* axis, std::string what, std::string saves, std::string set = {},
                         const char* costs = notMeasured) {
        if (applies) list.push_back({axis, std::move(what), costs, std::move(saves), std::move(set), false});
    };
    const auto plate = [](const BlockModel& block) { return block.plateOf >= 0; };
    const auto plates = std::count_if(model.blocks.begin(), model.blocks.end(), plate);
    const auto cells = std::count_if(model.blocks.begin(), model.blocks.end(), [](const auto& b) { return b.cell; });
    const bool moves = std::any_of(scene.stages.begin(), scene.stages.end(),
                                   [](const Stage& stage) { return stage.kind == StageKind::Dynamic; });
    const bool multipliers = numericsOf(scene.analysis).contact == ContactMethod::AugmentedLagrangian;
    const int elements = mostElements(scene, model);
    add(scene.analysis.modelEverything, "model_everything", "model_everything true → false",
        "unknowns of fixed and of sleeping blocks", "analysis.model_everything=false",
        "nothing beyond the tolerances of the analysis");
    add(elements > fewElements, "divisions",
        "divisions " + std::to_string(elements) + " → " + std::to_string(elements / 2),
        "half of the unknowns of bolts");
    if (scene.analysis.preset > Preset::Sketch) {
        const auto coarser = static_cast<Preset>(static_cast<int>(scene.analysis.preset) - 1);
        add(true, "preset", "preset " + presetName(scene.analysis.preset) + " → " + presetName(coarser),
            "what its page says", "analysis.preset=" + presetName(coarser));
    }
    add(moves, "time_step", "time step × 2", "about half of the steps in motion");
    add(multipliers, "contact", "contact augmented-lagrangian → penalty", "up to 40 solutions per step",
        "analysis.contact=penalty");
    add(cells > 0, "sub_blocks", "cells × 2 in size", "about three quarters of the unknowns of cells");
    add(plates > 0, "plate", "plates as blocks → springs", std::to_string(6 * plates) + " unknowns");
    return list;
}

std::string textOf(const NextLeftOut& next) {
    return next.what + ": " + (next.measured ? "" : "cost ") + next.costs + "; saves " + next.saves;
}

}  // namespace keyblock
