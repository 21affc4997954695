// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/results/verdict.h"

#include <algorithm>

namespace keyblock {

Verdict verdictOf(const std::vector<StageRecord>& records, std::size_t stages) {
    Verdict verdict;
    bool decided = records.size() == stages;
    for (const StageRecord& record : records) {
        const Outcome outcome = record.result.outcome;
        decided = decided && record.ended && (endedAsPlanned(outcome) || endedUnstable(outcome));
        if (!record.ended) continue;
        if (endedUnstable(outcome)) verdict.stands = false;
        for (const UnstableBlock& block : record.result.unstable) {
            verdict.stands = false;
            const bool told = std::any_of(verdict.blocks.begin(), verdict.blocks.end(),
                                          [&](const StageUnstable& other) { return other.block.block == block.block; });
            if (!told) verdict.blocks.push_back({record.result.stage, block});
        }
    }
    if (decided && !verdict.stands) verdict.stands = true;
    return verdict;
}

std::optional<StageResult> worstBalanced(const std::vector<StageRecord>& records) {
    std::optional<StageResult> worst;
    for (const StageRecord& record : records) {
        const WorstBalance& balance = record.result.health.worst;
        if (balance.block >= 0 && (!worst || balance.share > worst->health.worst.share)) worst = record.result;
    }
    return worst;
}

}  // namespace keyblock
