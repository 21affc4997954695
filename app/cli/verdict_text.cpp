// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/verdict_text.h"

#include "app/cli/text_table.h"
#include "solver/results/verdict.h"
#include "solver/results/words.h"

#include <cmath>

namespace keyblock::cli {

namespace {

constexpr std::size_t mostTold = 20;  // blocks; --json has all
constexpr double balanceWarned = 0.01;  // energy balance error from which a summary warns
constexpr double bodyAllowed = 1e-3;  // of a block's weight, where a stage does not say

std::string answer(const Verdict& verdict) {
    if (!verdict.stands)
        return "undecided";
    return *verdict.stands ? "yes" : "NO";
}

std::string blockTable(const RunSource& run, const Verdict& verdict) {
    std::vector<TextRow> rows;
    for (const StageUnstable& one : verdict.blocks)
        if (rows.size() < mostTold)
            rows.push_back({blockName(run.blockNames(), one.block.block), std::string(wordOf(one.block.mode)),
                            shown(one.block.moved), shown(one.block.weight / 1e3), stageName(run.scene(), one.stage)});
    if (rows.empty())
        return {};
    const std::size_t left = verdict.blocks.size() - rows.size();
    return "\n" +
           textTable({{"not stable"}, {""}, {"moved, m", Align::Right}, {"weight, kN", Align::Right}, {"stage"}}, rows) +
           (left > 0 ? "and " + std::to_string(left) + " more\n" : "") + "\n";
}

std::string worstLine(const RunSource& run, const std::vector<StageRecord>& records) {
    const std::optional<StageResult> worst = worstBalanced(records);
    if (!worst)
        return {};
    const WorstBalance& balance = worst->health.worst;
    const Stage& stage = run.scene().stages[static_cast<std::size_t>(worst->stage)];
    const std::string line = "block " + blockName(run.blockNames(), balance.block) + ", " + shown(balance.share) +
                             " of its weight unbalanced in stage '" + stage.name + "'\n";
    const bool tooMuch = balance.share > stage.until.body.value_or(bodyAllowed) * (1.0 + 1e-9);
    return "worst   " + line + (tooMuch ? "warning: that is more than the stage allows: round-off hides the rest\n" : "");
}

std::string looseLine(const RunSource& run, const std::vector<StageRecord>& records) {
    std::string names;
    std::size_t count = 0;
    for (const StageRecord& record : records)
        for (const int block : record.result.loose) {
            names += (count++ > 0 ? ", " : "") + blockName(run.blockNames(), block);
        }
    return count == 0 ? "" : "loose   removed, too small to decide: " + names + "\n";
}

std::string energyWarning(const RunSource& run, const std::vector<StageRecord>& records) {
    std::string text;
    for (const StageRecord& record : records)
        if (const double error = record.result.health.balanceError; std::abs(error) > balanceWarned)
            text += "warning: the energy of stage '" + stageName(run.scene(), record.result.stage) +
                    "' does not balance; " + shown(error) + " of it is left over\n";
    return text;
}

}  // namespace

std::string verdictText(const RunSource& run) {
    const std::vector<StageRecord> records = run.stages();
    const Verdict verdict = verdictOf(records, run.scene().stages.size());
    return "stable  " + answer(verdict) + "\n" + blockTable(run, verdict) + worstLine(run, records) +
           looseLine(run, records) + energyWarning(run, records);
}

}  // namespace keyblock::cli
