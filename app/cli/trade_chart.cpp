// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/trade_chart.h"

#include "app/cli/output.h"
#include "solver/files/atomic_file.h"

#ifdef KEYBLOCK_HAS_FIGURES
#include "solver/trade/change_text.h"
#include "solver/trade/trade_errors.h"
#include "ui/figure/trade_figure.h"

#include <algorithm>
#endif

namespace keyblock::cli {

#ifdef KEYBLOCK_HAS_FIGURES

namespace {

constexpr double leastShown = 1e-3;  // of the scatter

/// How far the reference itself may be off, where quantities do not converge regularly.
std::string uncertaintyText(const Trade& trade) {
    double largest = 0.0;
    for (std::size_t q = 0; q < trade.quantities.size(); ++q)
        if (trade.points[trade.reference].values[q].value != 0.0) largest = std::max(largest, scatterOf(trade, q));
    return largest < leastShown ? "" : ", itself known to ± " + changeText(largest);
}

}  // namespace

void writeTradeChart(const Trade& trade, const Scene& scene, const std::filesystem::path& folder) {
    if (!trade.points.front().failure.empty()) return;
    TradeChart chart = tradeChartOf(trade);
    chart.title = "Accuracy and time: " + (scene.title.empty() ? "untitled scene" : scene.title);
    chart.subtitle =
        "Each dot is a run; its error is the largest of all quantities of interest, against the run with the "
        "finest settings (" +
        threeDigits(trade.points[trade.reference].seconds) + " s" + uncertaintyText(trade) + ").";
    chart.foot = "Keyblock · keyblock trade";
    try {
        const std::string bytes = paintTrade(chart, PaperFormat::Svg);
        writeAtomically(folder / "trade.svg", [&](std::ostream& out) { out << bytes; });
    } catch (const CannotDraw& problem) {
        print("no chart: " + std::string(problem.what()) + "\n");
    }
}

#else

void writeTradeChart(const Trade&, const Scene&, const std::filesystem::path&) {
    print("this program was built without figures, so trade.svg is left out\n");
}

#endif

}  // namespace keyblock::cli
