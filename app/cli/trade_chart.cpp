// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/trade_chart.h"

#include "app/cli/output.h"
#include "solver/files/atomic_file.h"
#include "solver/scene/number_text.h"
#include "solver/trade/trade_errors.h"

#ifdef KEYBLOCK_HAS_FIGURES
#include "ui/figure/trade_figure.h"
#endif

namespace keyblock::cli {

#ifdef KEYBLOCK_HAS_FIGURES

void writeTradeChart(const Trade& trade, const Scene& scene, const std::filesystem::path& folder) {
    if (!trade.points.front().failure.empty()) return;
    const TradePoint& reference = trade.points[trade.reference];
    TradeChart chart;
    chart.title = "Accuracy and time: " + (scene.title.empty() ? "untitled scene" : scene.title);
    chart.subtitle =
        "Each dot is a run; its error is the largest of all quantities of interest, against the run with the "
        "finest settings (" +
        rounded(reference.seconds) + " s).";
    chart.foot = "Keyblock · keyblock trade";
    for (std::size_t i = 0; i < trade.points.size(); ++i) {
        if (static_cast<int>(i) == trade.reference && i != 0) continue;
        const TradePoint& point = trade.points[i];
        const bool onFront = isOnFront(trade, i);
        chart.dots.push_back({point.seconds, largestError(point, reference, trade.quantities), point.axis,
                              nameOf(point), onFront, onFront || i == 0});
    }
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
