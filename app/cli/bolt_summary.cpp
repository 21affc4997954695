// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/bolt_summary.h"

#include "app/cli/text_table.h"
#include "solver/results/chains.h"
#include "solver/results/words.h"

#include <algorithm>

namespace keyblock::cli {

namespace {

constexpr std::size_t mostChains = 12;
constexpr std::size_t mostLinks = 6;

std::string chainLine(const RunSource& run, const std::vector<Event>& events, const std::vector<std::size_t>& chain) {
    std::string text;
    for (std::size_t i = 0; i < std::min(chain.size(), mostLinks); ++i)
        text += (i == 0 ? "  " : " → ") + eventPhrase(run, events[chain[i]]);
    if (chain.size() > mostLinks)
        text += " → " + std::to_string(chain.size() - mostLinks) + " more";
    return text + "\n";
}

}  // namespace

std::string eventPhrase(const RunSource& run, const Event& event) {
    std::string text(wordOf(event.kind));
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
    std::string text = "\nwhat led to what, at one load\n";
    for (std::size_t i = 0; i < std::min(chains.size(), mostChains); ++i)
        text += chainLine(run, events, chains[i]);
    if (chains.size() > mostChains)
        text += "  and " + std::to_string(chains.size() - mostChains) + " more; all are in 'info --json'\n";
    return text;
}

std::string boltEnergyTable(const RunSource& run) {
    if (run.scene().bolts.empty() || run.frames().empty())
        return {};
    const Frame frame = run.frame(run.frames().size() - 1);
    std::vector<TextRow> rows;
    for (std::size_t b = 0; b < frame.bolts.size(); ++b) {
        const BoltFrame& bolt = frame.bolts[b];
        rows.push_back({boltName(run.scene(), static_cast<int>(b)), shown(bolt.elasticEnergy),
                        shown(bolt.plasticEnergy), shown(bolt.bondEnergy)});
    }
    return "\n" + textTable({{"energy taken by bolt"},
                             {"elastic, J", Align::Right},
                             {"plastic, J", Align::Right},
                             {"bond, J", Align::Right}},
                            rows);
}

}  // namespace keyblock::cli
