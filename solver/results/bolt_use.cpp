// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/results/bolt_use.h"

#include "solver/scene/number_text.h"
#include "solver/scene/solved_blocks.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace keyblock {

namespace {

/// First rows of the blocks through which a bolt passes, from its head on, without the block at its far end.
std::vector<int> heldBlocks(const std::vector<BoltNodeFrame>& nodes, const SolvedBlocks& solved) {
    std::vector<int> passed;  // starting at the far end
    for (const BoltNodeFrame& node : nodes) {
        if (node.block < 0) continue;
        const int block = solved.blocks[node.block].block;
        const int row = solved.firstOf[block];
        if (std::find(passed.begin(), passed.end(), row) == passed.end()) passed.push_back(row);
    }
    if (!passed.empty()) passed.erase(passed.begin());
    std::reverse(passed.begin(), passed.end());
    return passed;
}

}  // namespace

BoltUse boltUse(int bolt, const BoltExtremes& extremes) {
    BoltUse result;
    result.bolt = bolt;
    result.extremes = extremes;
    double highest = 0.0;
    for (const BoltStrengthRow& row : boltStrengths) {
        const double use = (extremes.*row.use).value;
        if (use < 0.0) continue;
        result.use[static_cast<std::size_t>(row.strength)] = use;
        if (use <= highest) continue;
        highest = use;
        result.governs = row.strength;
    }
    return result;
}

std::string useText(const BoltUse& use) {
    if (!use.governs) return {};
    return std::string(rowOf(*use.governs).key) + " used to " + rounded(std::round(1000.0 * use.highest()) / 10.0) +
           " %" + (use.governs == BoltStrength::Steel ? " of ultimate strength" : "");
}

/// Bolts are installed at the start of a stage, so its first frame shows them.
std::vector<std::vector<BoltNodeFrame>> boltsAsInstalled(const RunSource& run) {
    std::vector<std::vector<BoltNodeFrame>> bolts(run.scene().bolts.size());
    int stage = -1;
    for (std::size_t i = 0; i < run.frames().size(); ++i) {
        if (run.frames()[i].stage == stage) continue;
        if (std::ranges::none_of(bolts, [](const auto& nodes) { return nodes.empty(); })) break;
        stage = run.frames()[i].stage;
        Frame frame = run.frame(i);
        for (std::size_t b = 0; b < bolts.size(); ++b)
            if (bolts[b].empty()) bolts[b] = std::move(frame.bolts[b].nodes);
    }
    return bolts;
}

std::vector<BoltUse> boltUses(const RunSource& run) {
    std::vector<BoltUse> uses;
    if (run.frames().empty()) return uses;
    const Frame last = run.frame(run.frames().size() - 1);
    for (std::size_t b = 0; b < last.extremes.size(); ++b)
        uses.push_back(boltUse(static_cast<int>(b), last.extremes[b]));
    if (uses.empty()) return uses;
    const SolvedBlocks solved = solvedBlocks(run.scene());
    const auto installed = boltsAsInstalled(run);
    for (std::size_t b = 0; b < uses.size(); ++b) uses[b].holds = heldBlocks(installed[b], solved);
    return uses;
}

}  // namespace keyblock
