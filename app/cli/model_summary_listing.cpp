// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/model_summary_listing.h"

#include "solver/scene/units.h"
#include "solver/scene/visible_text.h"

#include <array>
#include <charconv>
#include <cmath>

namespace keyblock::cli {

namespace {

constexpr double mostCounted = 1e15;
constexpr double century = 100.0 * 365.25 * 86400.0;  // [s]

std::string counted(int count, const std::string& what) {
    return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

/// Rounds to two digits: an estimate is no more accurate than that.
std::string rough(double value) {
    if (!(value < mostCounted)) return "more than 1e15";
    std::array<char, 64> buffer{};
    const double size = value > 0.0 ? std::pow(10.0, std::floor(std::log10(value)) - 1.0) : 1.0;
    const double rounded = std::round(value / size) * size;
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), rounded, std::chars_format::fixed,
                                   size >= 1.0 ? 0 : static_cast<int>(std::lround(-std::log10(size))));
    return {buffer.data(), end.ptr};
}

std::string duration(double seconds) {
    if (seconds < 120.0)
        return rough(seconds) + " s";
    if (seconds < 7200.0)
        return rough(seconds / 60.0) + " min";
    return seconds < century ? rough(seconds / 3600.0) + " h" : "more than 100 years";
}

std::string partLines(const ModelCounts& counts) {
    std::string lines = "modelled: " + counted(counts.unknowns(), "unknown") + "\n";
    const auto line = [&](int count, const std::string& what, const std::string& detail, int unknowns) {
        if (count == 0)
            return;
        lines += "  " + counted(count, what) + detail;
        if (unknowns >= 0)
            lines += ", " + counted(unknowns, "unknown");
        lines += '\n';
    };
    const bool some = counts.cells > 0 && counts.cells < counts.blocks;
    const std::string cells = some ? " (" + counted(counts.cells, "cell") + " of them)" : "";
    const std::string held = counts.fixed > 0 ? " (" + std::to_string(counts.fixed) + " fixed)" : "";
    line(counts.blocks, counts.cells == counts.blocks ? "cell" : "block", cells + held, counts.blockUnknowns);
    line(counts.plates, "plate", counts.plates == 1 ? " modelled as a block" : " modelled as blocks",
         counts.plateUnknowns);
    line(counts.bolts, "bolt",
         " of " + counted(counts.nodes, "node") + " (" + std::to_string(counts.realAnchors) + " bonded)",
         counts.boltUnknowns);
    line(counts.contacts, "contact", " at the start", -1);
    line(counts.gluedEdges, "bonded edge", " between cells", -1);
    line(counts.heldPoints, "point support", "", -1);
    return lines;
}

std::string estimateLines(const CostEstimate& estimate) {
    std::string lines = "a run may take " + duration(estimate.seconds) + " (" + duration(estimate.secondsLeast) +
                        " to " + duration(estimate.secondsMost) + ") and " + rough(estimate.memory / 1e6) + " MB\n";
    for (const StageCost& stage : estimate.stages)
        lines += "  " + visibleText(stage.name) + ": " + rough(stage.steps) + " steps, " + rough(stage.passes) +
                 " iterations (" + rough(stage.least) + " to " + rough(stage.most) + ")\n";
    lines += "  an iteration takes " + rough(fromSi(estimate.passSeconds, namedUnit("ms"))) + " ms, the rest of a step " +
             rough(fromSi(estimate.stepSeconds, namedUnit("ms"))) + " ms\n";
    for (const std::string& sentence : estimate.assumes)
        lines += "  " + sentence + '\n';
    return lines;
}

}  // namespace

std::string modelSummaryLines(const ModelSummary& summary) {
    std::string lines = partLines(summary.counts) + "left out:\n";
    for (const LeftOut& part : summary.leftOut)
        lines += "  " + visibleText(part.what + ": " + part.why) + " (saves " + part.saves + ")\n";
    if (!summary.next.empty()) lines += "could be left out next:\n";
    for (const NextLeftOut& next : summary.next) {
        lines += "  " + visibleText(textOf(next));
        if (!next.set.empty()) lines += " (--set " + visibleText(next.set) + ")";
        lines += '\n';
    }
    if (!summary.estimate.stages.empty())
        lines += estimateLines(summary.estimate);
    return lines;
}

}  // namespace keyblock::cli
