// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/results/verdict.h"

#include "solver/results/result_names.h"
#include "solver/scene/automatic.h"
#include "solver/scene/number_text.h"
#include "solver/scene/preset.h"

#include <algorithm>
#include <cmath>

namespace keyblock {

namespace {

constexpr double residualAllowed = 0.02;  // allowed unbalanced force at rest, as a fraction of the acting forces
constexpr double penetrationAllowed = 0.05;  // allowed penetration, as a fraction of the size of the smaller block
constexpr double balanceAllowed = 0.01;  // allowed error of the energy balance, as a fraction of its largest term

std::string percent(double share) { return rounded(100.0 * share) + " %"; }

/// The warning about the energy balance of a stage; empty if its error is allowed.
std::string balanceWarning(double error, const std::string& inStage) {
    if (error <= balanceAllowed) return {};
    if (!std::isfinite(error)) return "the energy balance error" + inStage + " is not a finite number";
    return "energy balance error of " + percent(error) + inStage + ", more than " + percent(balanceAllowed);
}

/// The warning about the largest penetration of a stage; empty if it is allowed.
std::string penetrationWarning(double ratio, const std::string& inStage) {
    if (ratio <= penetrationAllowed) return {};
    return "blocks penetrate each other by up to " + percent(ratio) + " of the size of the smaller one" + inStage +
           ", more than " + percent(penetrationAllowed) + ": contacts are too soft for the forces on them";
}

/// The warning about the unbalanced forces of a static stage, whose search ends where round-off does not allow a better
/// balance; empty if they are allowed.
std::string residualWarning(const Stage& stage, double residual, const std::string& inStage) {
    if (stage.kind != StageKind::Static || residual <= residualAllowed) return {};
    return "forces of " + percent(residual) + " of those that act are unbalanced" + inStage + ", more than " +
           percent(residualAllowed) + ": stiffnesses differ by too many digits, for example of contacts and bolts";
}

}  // namespace

Verdict verdictOf(const std::vector<StageRecord>& records, const Scene& scene) {
    Verdict verdict;
    bool decided = records.empty() ? scene.stages.empty() : !stageAfter(scene, records.back().result);
    for (const StageRecord& record : records) {
        const Outcome outcome = record.result.outcome;
        decided = decided && record.ended && (endedAsPlanned(outcome) || endedUnstable(outcome));
        if (!record.ended) continue;
        if (endedUnstable(outcome)) verdict.stands = false;
        for (const UnstableBlock& block : record.result.unstable) {
            verdict.stands = false;
            const bool listed = std::any_of(verdict.blocks.begin(), verdict.blocks.end(),
                                            [&](const StageUnstable& other) { return other.block.block == block.block; });
            if (!listed) verdict.blocks.push_back({record.result.stage, block});
        }
    }
    if (decided && !verdict.stands) verdict.stands = true;
    return verdict;
}

std::vector<StageWarning> stageWarnings(const RunSource& run) {
    std::vector<StageWarning> warnings;
    if (const std::string_view text = presetWarning(run.scene().analysis.preset); !text.empty())
        warnings.push_back({-1, std::string(text)});
    for (const StageRecord& record : run.stages()) {
        if (!record.ended) continue;
        const StageResult& result = record.result;
        const std::string in = " in stage '" + stageName(run.scene(), result.stage) + "'";
        const WorstBalance& worst = result.health.worst;
        const Until& until = run.scene().stages[result.stage].until;
        const double allowed = until.body.value_or(automaticBody);
        if (worst.block >= 0 && worst.share > allowed * (1.0 + 1e-9))
            warnings.push_back({result.stage, "block " + blockName(run.blockNames(), worst.block) + " has " +
                                                  percent(worst.share) + " of its weight unbalanced" + in + ", more than " +
                                                  percent(allowed)});
        if (const std::string text = balanceWarning(std::abs(result.health.balanceError), in); !text.empty())
            warnings.push_back({result.stage, text});
        if (const std::string text = residualWarning(run.scene().stages[result.stage], result.health.maxResidual, in);
            !text.empty())
            warnings.push_back({result.stage, text});
        if (const std::string text = penetrationWarning(result.health.maxPenetrationRatio, in); !text.empty())
            warnings.push_back({result.stage, text});
    }
    return warnings;
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
