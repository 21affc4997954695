// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The summary: whether the section is stable, what moved, and the bolts that were used
// most.
#include "solver/results/result_names.h"
#include "solver/run/failed_parts.h"
#include "solver/scene/number_text.h"
#include "ui/report/report_facts.h"

#include <algorithm>
#include <cmath>

namespace keyblock::report {

namespace {

constexpr std::size_t mostInSummary = 20;  // blocks, joints or bolts

std::string answerText(const Facts& facts) {
    const Verdict& verdict = facts.verdict;
    if (!verdict.stands) return "The run does not show whether the section is stable.";
    if (*verdict.stands) return "The section is stable in all stages.";
    std::string names;
    for (const StageUnstable& one : verdict.blocks) {
        const std::string name = stageName(facts.scene(), one.stage);
        if (names.find("'" + name + "'") == std::string::npos) names += (names.empty() ? "'" : ", '") + name + "'";
    }
    return "The section is NOT stable" + (names.empty() ? "." : " in stage " + names + ".");
}

std::string settledText(const Facts& facts) {
    std::string names;
    for (std::size_t i = 0; i < std::min(facts.settled.size(), mostInSummary); ++i)
        names += (i == 0 ? "" : ", ") + facts.block(facts.settled[i]);
    const bool all = facts.settled.size() == facts.verdict.blocks.size();
    return std::string(all ? "All of these blocks" : "Of these blocks, " + names) +
           " came to rest later in the run, within a tenth of their size of their initial positions; a longer stage may "
           "show that the section is stable.";
}

ReportTable unstableTable(const Facts& facts) {
    ReportTable table{
        "Blocks that are not stable", {{"Block"}, {"Movement"}, {"Stage"}, {"Moved", true}, {"Weight, kN", true}}, {}};
    for (const StageUnstable& one : facts.verdict.blocks) {
        if (table.rows.size() == mostInSummary) break;
        table.rows.push_back({facts.block(one.block.block), std::string(wordOf(one.block.mode)),
                              stageName(facts.scene(), one.stage), lengthText(one.block.moved),
                              inUnit(one.block.weight, "kN")});
    }
    if (facts.verdict.blocks.size() > table.rows.size())
        table.caption += "; the first " + std::to_string(table.rows.size()) + " of " +
                         std::to_string(facts.verdict.blocks.size());
    return table;
}

ReportTable failedTable(const Facts& facts) {
    ReportTable table{"Bolts that failed across them", {{"Bolt"}, {"Failure"}, {"Stage"}, {"Time", true}}, {}};
    for (const FailedBolt& bolt : failedParts(facts.run, facts.verdict).bolts)
        if (table.rows.size() < mostInSummary)
            table.rows.push_back({boltName(facts.scene(), bolt.bolt), std::string(rowOf(bolt.event).title),
                                  stageName(facts.scene(), bolt.stage), numeral(bolt.time)});
    return table;
}

std::string highestUseText(const Facts& facts) {
    const auto most = std::ranges::max_element(facts.designs, {}, [](const BoltDesign& d) { return d.use.highest(); });
    if (most == facts.designs.end() || !most->use.governs) return {};
    return "The bolt with the highest utilisation is " + boltName(facts.scene(), most->use.bolt) + ": " +
           useText(most->use) + ", with an axial force of up to " + inUnit(most->use.extremes.axialForce.value, "kN") +
           " kN.";
}

std::string carriedText(const Facts& facts) {
    std::string text;
    for (const BoltDesign& design : facts.designs) {
        if (design.carries.empty()) continue;
        const CarriedBlock& block = design.carries.front();
        text += (text.empty() ? "At the end of the run, " : "; ") + boltName(facts.scene(), design.use.bolt) +
                " carries " + facts.block(block.block) + " (" + inUnit(block.weight, "kN") + " kN) with " +
                inUnit(block.force, "kN") + " kN";
    }
    return text.empty() ? text : text + ".";
}

}  // namespace

void addSummary(const Facts& facts, ReportSection& section) {
    addText(section, answerText(facts), ReportTextKind::Answer);
    if (!isFinished(facts.run))
        addText(section, "The run is not complete; this report shows the results so far.", ReportTextKind::Warning);
    addTable(section, unstableTable(facts));
    if (!facts.settled.empty()) addText(section, settledText(facts));
    addTable(section, failedTable(facts));
    for (const std::string& text : {highestUseText(facts), carriedText(facts)})
        if (!text.empty()) addText(section, text);
    for (const StageWarning& warning : stageWarnings(facts.run))
        addText(section, "Warning: " + warning.text + ".", ReportTextKind::Warning);
}

}  // namespace keyblock::report
