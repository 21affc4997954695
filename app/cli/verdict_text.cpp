// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/verdict_text.h"

#include "app/cli/text_table.h"
#include "solver/results/verdict.h"
#include "solver/results/result_names.h"
#include "solver/run/failed_parts.h"
#include "solver/scene/number_text.h"
#include "solver/scene/units.h"
#include "solver/scene/visible_text.h"

namespace keyblock::cli {

namespace {

constexpr std::size_t mostListed = 20;  // blocks, joints or bolts; --json lists all

std::string answer(const Verdict& verdict) {
    if (!verdict.stands)
        return "undecided";
    return *verdict.stands ? "yes" : "NO";
}

std::string more(std::size_t all, std::size_t listed) {
    return all > listed ? "and " + std::to_string(all - listed) + " more\n" : "";
}

std::string blockTable(const RunSource& run, const Verdict& verdict) {
    std::vector<TextRow> rows;
    for (const StageUnstable& one : verdict.blocks)
        if (rows.size() < mostListed)
            rows.push_back({blockName(run.blockNames(), one.block.block), std::string(wordOf(one.block.mode)),
                            shown(one.block.moved), shown(fromSi(one.block.weight, namedUnit("kN"))), stageName(run.scene(), one.stage)});
    if (rows.empty())
        return {};
    const std::string text =
        textTable({{"not stable"}, {""}, {"moved, m", Align::Right}, {"weight, kN", Align::Right}, {"stage"}}, rows);
    return "\n" + text + more(verdict.blocks.size(), rows.size()) + "\n";
}

/// A movement [m] in mm; 0 if it is round-off compared with the other movement.
std::string millimetres(double movement, double other) {
    return movement < 1e-9 * other ? "0" : rounded(fromSi(movement, namedUnit("mm")));
}

std::string jointTable(const RunSource& run, const std::vector<FailedJoint>& joints) {
    std::vector<TextRow> rows;
    for (const FailedJoint& joint : joints)
        if (rows.size() < mostListed)
            rows.push_back({blockName(run.blockNames(), joint.blockA) + " on " + blockName(run.blockNames(), joint.blockB),
                            joint.opened ? "opened" : "slid", millimetres(joint.slip, joint.opening),
                            millimetres(joint.opening, joint.slip)});
    if (rows.empty()) return {};
    const std::string text =
        textTable({{"failed joints around them"}, {""}, {"slip, mm", Align::Right}, {"opening, mm", Align::Right}},
                  rows);
    return text + more(joints.size(), rows.size()) + "\n";
}

std::string boltTable(const RunSource& run, const std::vector<FailedBolt>& bolts) {
    std::vector<TextRow> rows;
    for (const FailedBolt& bolt : bolts)
        if (rows.size() < mostListed)
            rows.push_back({boltName(run.scene(), bolt.bolt), std::string(rowOf(bolt.event).title),
                            stageName(run.scene(), bolt.stage), rounded(bolt.time)});
    if (rows.empty()) return {};
    const std::string text = textTable({{"failed bolts across them"}, {""}, {"stage"}, {"time", Align::Right}}, rows);
    return text + more(bolts.size(), rows.size()) + "\n";
}

std::string worstLine(const RunSource& run, const std::vector<StageRecord>& records) {
    const std::optional<StageResult> worst = worstBalanced(records);
    if (!worst)
        return {};
    return visibleText("worst   block " + blockName(run.blockNames(), worst->health.worst.block) + ", " +
                       rounded(worst->health.worst.share) + " of its weight unbalanced in stage '" +
                       stageName(run.scene(), worst->stage) + "'") +
           "\n";
}

std::string looseLine(const RunSource& run, const std::vector<StageRecord>& records) {
    std::string names;
    std::size_t count = 0;
    for (const StageRecord& record : records)
        for (const int block : record.result.loose) {
            names += (count++ > 0 ? ", " : "") + blockName(run.blockNames(), block);
        }
    return count == 0 ? "" : "loose   removed, too small to affect the verdict: " + visibleText(names) + "\n";
}

std::string warningLines(const RunSource& run) {
    std::string text;
    for (const StageWarning& warning : stageWarnings(run)) text += "warning: " + visibleText(warning.text) + "\n";
    return text;
}

}  // namespace

std::string verdictText(const RunSource& run) {
    const std::vector<StageRecord> records = run.stages();
    const Verdict verdict = verdictOf(records, run.scene());
    const FailedParts failed = failedParts(run, verdict);
    return "stable  " + answer(verdict) + "\n" + blockTable(run, verdict) + jointTable(run, failed.joints) +
           boltTable(run, failed.bolts) + worstLine(run, records) + looseLine(run, records) + warningLines(run);
}

}  // namespace keyblock::cli
