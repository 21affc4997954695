// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/bolt_summary.h"

#include "app/cli/text_table.h"
#include "solver/results/bolt_use.h"
#include "solver/results/chains.h"
#include "solver/results/result_names.h"
#include "solver/scene/number_text.h"
#include "solver/scene/units.h"
#include "solver/scene/visible_text.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

namespace keyblock::cli {

namespace {

constexpr std::size_t mostChains = 12;
constexpr std::size_t mostLinks = 6;
constexpr std::size_t mostBolts = 10;  // listed
constexpr std::size_t mostHeld = 3;  // supported blocks named for each bolt
constexpr double nothing = 1e-9;  // fraction of the axial force; smaller values are round-off

/// "62.1 at 1.25": a force or moment in kilo-units and its distance from the far end [m]. \param axial largest axial
/// force [N], compared with which round-off is shown as 0.
std::string peakText(const BoltPeak& peak, double axial) {
    if (peak.stage < 0) return "–";
    if (std::abs(peak.value) < nothing * std::abs(axial)) return "0";
    return rounded(perSi(namedUnit("kN")) * peak.value) + " at " + rounded(peak.at);
}

std::string useText(const std::optional<double>& use) {
    if (!use) return "–";
    const double percent = 100.0 * *use;
    return percent < 9.95 ? rounded(0.1 * std::round(10.0 * percent)) : std::to_string(std::lround(percent));
}

std::string heldText(const RunSource& run, const std::vector<int>& blocks) {
    std::string text;
    for (std::size_t i = 0; i < std::min(blocks.size(), mostHeld); ++i)
        text += (i > 0 ? ", " : "") + blockName(run.blockNames(), blocks[i]);
    if (blocks.size() > mostHeld) text += " and " + std::to_string(blocks.size() - mostHeld) + " more";
    return text.empty() ? "nothing" : text;
}

TextRow useRow(const RunSource& run, const BoltUse& use) {
    const BoltExtremes& peaks = use.extremes;
    const double axial = peaks.axialForce.value;
    TextRow row{boltName(run.scene(), use.bolt), peakText(peaks.axialForce, axial),
                stageName(run.scene(), peaks.axialForce.stage),
                peaks.axialForce.stage < 0 ? "" : rounded(peaks.axialForce.time), peakText(peaks.shearForce, axial),
                peakText(peaks.moment, axial)};
    for (const std::optional<double>& share : use.use) row.push_back(useText(share));
    row.push_back(use.governs ? std::string(rowOf(*use.governs).key) : "–");
    row.push_back(heldText(run, use.holds));
    return row;
}

/// A column with a heading such as "N, kN (at m)".
TextColumn peakColumn(BoltQuantity quantity) {
    const BoltQuantityRow& row = rowOf(quantity);
    return {std::string(row.brief) + ", " + std::string(row.unit) + " (at m)", Align::Right};
}

std::vector<TextColumn> useColumns() {
    std::vector<TextColumn> columns{{"bolt"}, peakColumn(BoltQuantity::AxialForce), {"stage"}, {"time", Align::Right},
                                    peakColumn(BoltQuantity::ShearForce), peakColumn(BoltQuantity::Moment)};
    for (const BoltStrengthRow& row : boltStrengths) columns.push_back({std::string(row.key) + ", %", Align::Right});
    columns.push_back({"governs"});
    columns.push_back({"supports"});
    return columns;
}

std::string chainLine(const RunSource& run, const std::vector<Event>& events, const std::vector<std::size_t>& chain) {
    std::string text;
    for (std::size_t i = 0; i < std::min(chain.size(), mostLinks); ++i)
        text += (i == 0 ? "  " : " → ") + eventPhrase(run, events[chain[i]]);
    if (chain.size() > mostLinks)
        text += " → " + std::to_string(chain.size() - mostLinks) + " more";
    return visibleText(text) + "\n";
}

}  // namespace

std::string eventPhrase(const RunSource& run, const Event& event) {
    std::string text(rowOf(event.kind).title);
    if (event.bolt >= 0)
        text += " of " + boltName(run.scene(), event.bolt);
    else if (event.block >= 0)
        text += " of " + blockName(run.blockNames(), event.block);
    if (event.node >= 0)
        text += " at node " + std::to_string(event.node);
    if (event.element >= 0)
        text += " in element " + std::to_string(event.element);
    return text;
}

std::string chainLines(const RunSource& run, const std::vector<Event>& events) {
    const auto chains = causeChains(events);
    if (chains.empty())
        return {};
    std::string text = "\nchains of failures at one load\n";
    for (std::size_t i = 0; i < std::min(chains.size(), mostChains); ++i)
        text += chainLine(run, events, chains[i]);
    if (chains.size() > mostChains)
        text += "  and " + std::to_string(chains.size() - mostChains) + " more; all are in 'info --json'\n";
    return text;
}

std::string boltUseTable(const RunSource& run) {
    std::vector<BoltUse> uses = boltUses(run);
    if (uses.empty())
        return {};
    std::stable_sort(uses.begin(), uses.end(),
                     [](const BoltUse& a, const BoltUse& b) { return a.highest() > b.highest(); });
    std::vector<TextRow> rows;
    for (std::size_t i = 0; i < std::min(uses.size(), mostBolts); ++i) rows.push_back(useRow(run, uses[i]));
    std::string text = "\nlargest forces of each bolt and use of its strengths over the run\n" +
                       textTable(useColumns(), rows);
    if (uses.size() > rows.size())
        text += "and " + std::to_string(uses.size() - rows.size()) + " more with lower use; all are in 'info --json'\n";
    return text;
}

std::string boltEnergyTable(const RunSource& run) {
    if (run.scene().bolts.empty() || run.frames().empty())
        return {};
    const Frame frame = run.frame(run.frames().size() - 1);
    std::vector<std::size_t> order(frame.bolts.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto all = [&](std::size_t b) {
        return frame.bolts[b].elasticEnergy + frame.bolts[b].plasticEnergy + frame.bolts[b].bondEnergy;
    };
    if (order.size() > mostBolts)
        std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return all(a) > all(b); });
    std::vector<TextRow> rows;
    for (const std::size_t b : order) {
        if (rows.size() == mostBolts) break;
        const BoltFrame& bolt = frame.bolts[b];
        rows.push_back({boltName(run.scene(), static_cast<int>(b)), shown(bolt.elasticEnergy),
                        shown(bolt.plasticEnergy), shown(bolt.bondEnergy)});
    }
    const std::string text = "\n" + textTable({{"energy taken by bolt"},
                                               {"elastic, J", Align::Right},
                                               {"plastic, J", Align::Right},
                                               {"bond, J", Align::Right}},
                                              rows);
    const std::size_t left = order.size() - rows.size();
    return left == 0 ? text : text + "and " + std::to_string(left) + " more with less energy; all are in 'info --json'\n";
}

}  // namespace keyblock::cli
