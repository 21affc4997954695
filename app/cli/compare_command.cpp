// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The command `compare`: prints which blocks fall in one of two runs and are stable in
// the other, the bolts that hold them, and the differences of displacements and forces.
#include "app/cli/cli_commands.h"
#include "app/cli/json_answers.h"
#include "app/cli/output.h"
#include "app/cli/store_warning.h"
#include "app/cli/text_table.h"
#include "solver/results/result_names.h"
#include "solver/results/run_comparison.h"
#include "solver/scene/number_text.h"
#include "solver/scene/units.h"
#include "solver/scene/visible_text.h"

#include <algorithm>
#include <cmath>

namespace keyblock::cli {

namespace {

constexpr std::size_t mostCompared = 10;  // rows of each table; --json lists all

/// Two runs with their comparison.
struct Pair {
    const RunStore &a, &b;
    const RunComparison& found;

    const RunStore& falling(const SavedBlock& one) const { return one.fallsInA ? a : b; }
    const RunStore& stable(const SavedBlock& one) const { return one.fallsInA ? b : a; }
    std::string name(const SharedBlock& block) const { return blockName(a.blockNames(), block.a); }
};

std::string kilo(double value) { return rounded(fromSi(value, namedUnit("kN"))); }

std::string remaining(std::size_t all) {
    return all > mostCompared ? "and " + std::to_string(all - mostCompared) + " more; all are in 'compare --json'\n"
                              : "";
}

std::string runLine(const char* which, const std::filesystem::path& file, const RunStore& run, const Verdict& verdict,
                    const std::vector<int>& settled) {
    const std::string answer = !verdict.stands ? "undecided" : *verdict.stands ? "stable" : "NOT stable";
    const std::string& title = run.scene().title;
    std::string text = std::string(which) + "  " + file.string() + (title.empty() ? "" : " (" + title + ")") + ": " +
                       answer;
    std::string names;
    for (std::size_t i = 0; i < std::min(settled.size(), mostCompared); ++i)
        names += (i == 0 ? "" : ", ") + blockName(run.blockNames(), settled[i]);
    if (settled.size() > mostCompared) names += " and " + std::to_string(settled.size() - mostCompared) + " more";
    if (!names.empty()) text += "; at rest near their positions at the end of the run: " + names;
    return visibleText(text) + "\n";
}

std::string blockLine(const RunComparison& found) {
    std::string text = std::to_string(found.shared) + " blocks are in both runs";
    if (found.onlyA > 0) text += ", " + std::to_string(found.onlyA) + " in A only";
    if (found.onlyB > 0) text += ", " + std::to_string(found.onlyB) + " in B only";
    return text + "\n";
}

/// The bolts that hold a block, as in "roof.3 (28.74 kN)".
std::string holdersText(const Pair& pair, const SavedBlock& one) {
    const RunStore& run = pair.stable(one);
    const int own = one.fallsInA ? one.block.b : one.block.a;
    std::string text;
    for (const HoldingBolt& bolt : one.heldBy) {
        text += (text.empty() ? "" : ", ") + boltName(run.scene(), bolt.bolt);
        text += bolt.on == own ? " (" + kilo(bolt.force) + " kN)" : " through " + blockName(run.blockNames(), bolt.on);
    }
    return text.empty() ? "no bolt" : text;
}

std::string savedTable(const Pair& pair) {
    std::vector<TextRow> rows;
    for (const SavedBlock& one : pair.found.saved) {
        if (rows.size() == mostCompared) break;
        const UnstableBlock& fall = one.fall.block;
        rows.push_back({pair.name(one.block), one.fallsInA ? "A" : "B", std::string(wordOf(fall.mode)),
                        stageName(pair.falling(one).scene(), one.fall.stage), rounded(one.moved), kilo(fall.weight),
                        holdersText(pair, one)});
    }
    if (rows.empty()) return "\nno block falls in one run and is stable in the other\n";
    return "\n" +
           textTable({{"falls in one run only"},
                      {"in"},
                      {"how"},
                      {"stage"},
                      {"moved, m", Align::Right},
                      {"weight, kN", Align::Right},
                      {"held in the other run by"}},
                     rows) +
           remaining(pair.found.saved.size());
}

std::string displacementTable(const Pair& pair) {
    std::vector<TextRow> rows;
    for (const BlockDifference& one : pair.found.blocks) {
        if (rows.size() == mostCompared || one.size() == 0.0) break;
        const auto millimetres = [](double metres) { return rounded(fromSi(metres, namedUnit("mm"))); };
        rows.push_back(
            {pair.name(one.block), millimetres(one.a.norm()), millimetres(one.b.norm()), millimetres(one.size())});
    }
    if (rows.empty()) return "\nno block is displaced differently\n";
    return "\n" +
           textTable({{"largest differences of displacement"},
                      {"A, mm", Align::Right},
                      {"B, mm", Align::Right},
                      {"difference, mm", Align::Right}},
                     rows) +
           remaining(pair.found.blocks.size());
}

std::string comparedPeak(const std::optional<BoltUse>& use) {
    return use ? rounded(fromSi(use->extremes.axialForce.value, namedUnit("kN"))) : "–";
}

std::string comparedUse(const std::optional<BoltUse>& use) {
    if (!use) return "–";
    const std::string text = useText(*use);
    return text.empty() ? "no force" : text;
}

double axialDifference(const BoltDifference& bolt) {
    const auto peak = [](const std::optional<BoltUse>& use) { return use ? use->extremes.axialForce.value : 0.0; };
    return std::abs(peak(bolt.a) - peak(bolt.b));
}

std::string boltTable(const Pair& pair) {
    std::vector<BoltDifference> bolts = pair.found.bolts;
    if (bolts.empty()) return {};
    std::ranges::stable_sort(bolts, std::ranges::greater{}, axialDifference);
    std::vector<TextRow> rows;
    for (const BoltDifference& bolt : bolts) {
        if (rows.size() == mostCompared) break;
        rows.push_back(
            {bolt.name, comparedPeak(bolt.a), comparedPeak(bolt.b), comparedUse(bolt.a), comparedUse(bolt.b)});
    }
    return "\n" +
           textTable({{"peak axial force of bolts"},
                      {"A, kN", Align::Right},
                      {"B, kN", Align::Right},
                      {"A governed by"},
                      {"B governed by"}},
                     rows) +
           remaining(bolts.size());
}

/// The answer to "what saved it?": each bolt with the blocks that it holds itself.
std::string answerLines(const Pair& pair) {
    std::vector<std::string> bolts;
    std::vector<std::string> texts;
    for (const SavedBlock& one : pair.found.saved)
        for (const HoldingBolt& bolt : one.heldBy) {
            const int own = one.fallsInA ? one.block.b : one.block.a;
            if (bolt.on != own) continue;
            const std::string name = std::string(one.fallsInA ? "B" : "A") + ": bolt " +
                                     boltName(pair.stable(one).scene(), bolt.bolt) + " holds ";
            const std::string block = pair.name(one.block) + " (" + kilo(one.fall.block.weight) + " kN)";
            const auto known = std::ranges::find(bolts, name);
            if (known == bolts.end()) {
                bolts.push_back(name);
                texts.push_back(name + block);
            } else texts[known - bolts.begin()] += ", " + block;
        }
    std::string lines;
    for (const std::string& text : texts) lines += visibleText(text) + "\n";
    return lines;
}

}  // namespace

ExitCode perform(const CompareOptions& options) {
    const RunStore a(options.a), b(options.b);
    warnOfMissingResults(a, options.a);
    warnOfMissingResults(b, options.b);
    const RunComparison found = compareRuns(a, b);
    if (options.json) {
        print(compareJson(a, b, found));
        return Done;
    }
    const Pair pair{a, b, found};
    print(runLine("A", options.a, a, found.a, found.settledA) + runLine("B", options.b, b, found.b, found.settledB) +
          blockLine(found) + answerLines(pair) + savedTable(pair) + displacementTable(pair) + boltTable(pair));
    return Done;
}

}  // namespace keyblock::cli
