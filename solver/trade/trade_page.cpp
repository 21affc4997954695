// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/trade/trade_page.h"

#include "solver/results/csv.h"
#include "solver/scene/number_text.h"
#include "solver/trade/change_text.h"
#include "solver/trade/trade_errors.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace keyblock {

namespace {

constexpr double megabyte = 1024.0 * 1024.0;

/// Points in order of their time.
std::vector<std::size_t> byTime(const Trade& trade) {
    std::vector<std::size_t> order(trade.points.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return trade.points[a].seconds < trade.points[b].seconds; });
    return order;
}

std::string errorText(const Trade& trade, const TradePoint& point, std::size_t q) {
    const auto error = errorOf(point, trade.points[trade.reference], trade.quantities, q);
    if (error) return changeText(*error);
    return point.values[q].value ? threeDigits(*point.values[q].value) : "–";
}

/// \param number text of a power.
std::string orderText(const ConvergenceOrder& order, std::string (*number)(double)) {
    switch (order.kind) {
        case ConvergenceOrder::Kind::Regular: return number(order.order);
        case ConvergenceOrder::Kind::NoEffect: return "no effect";
        case ConvergenceOrder::Kind::Irregular: return "not regular";
        case ConvergenceOrder::Kind::Unknown: break;
    }
    return "";
}

std::string scatterText(const Trade& trade, std::size_t q) {
    const double scatter = scatterOf(trade, q);
    if (scatter == 0.0) return "";
    const bool absolute = trade.points[trade.reference].values[q].value == 0.0;
    return "± " + (absolute ? threeDigits(scatter) : changeText(scatter));
}

std::string row(const std::vector<std::string>& cells) {
    std::string text = "|";
    for (std::string cell : cells) {
        for (std::size_t at = 0; (at = cell.find('|', at)) != std::string::npos; at += 2) cell.insert(at, "\\");
        text += " " + cell + " |";
    }
    return text + "\n";
}

std::string head(const std::vector<std::string>& cells) {
    return row(cells) + row(std::vector<std::string>(cells.size(), "---"));
}

std::string pointTable(const Trade& trade) {
    std::vector<std::string> titles{"settings", "time, s", "work", "largest error"};
    for (const std::string& quantity : trade.quantities) titles.push_back(quantity);
    std::string text = head(titles);
    for (const std::size_t i : byTime(trade)) {
        const TradePoint& point = trade.points[i];
        const double error = largestError(point, trade.points[trade.reference], trade.quantities);
        std::vector<std::string> cells{nameOf(point) + (isOnFront(trade, i) ? " **(front)**" : ""),
                                       threeDigits(point.seconds), threeDigits(workOf(point.work)), changeText(error)};
        for (std::size_t q = 0; q < trade.quantities.size(); ++q) cells.push_back(errorText(trade, point, q));
        text += row(cells);
    }
    return text;
}

std::vector<std::string> axesOf(const Trade& trade) {
    std::vector<std::string> axes;
    for (const TradePoint& point : trade.points)
        if (point.size > 0.0 && !std::count(axes.begin(), axes.end(), point.axis)) axes.push_back(point.axis);
    return axes;
}

std::string orderTable(const Trade& trade) {
    std::vector<std::string> titles{"quantity"};
    const std::vector<std::string> axes = axesOf(trade);
    titles.insert(titles.end(), axes.begin(), axes.end());
    titles.push_back("scatter");
    std::string rows;
    for (std::size_t q = 0; q < trade.quantities.size(); ++q) {
        std::vector<std::string> cells{trade.quantities[q]};
        bool any = false;
        for (const std::string& axis : axes) {
            cells.push_back(orderText(convergenceOrder(trade, axis, q), threeDigits));
            any = any || !cells.back().empty();
        }
        cells.push_back(scatterText(trade, q));
        if (any) rows += row(cells);
    }
    if (rows.empty()) return {};
    return "\n## Order of convergence\n\nThe error falls with this power of the setting, judged by the three finest "
           "settings of each axis. It is not regular where their differences change sign, or shrink by less than half "
           "of the lowest order of theory or more than twice the highest; then the errors above are known to within "
           "the scatter of these settings, after ± in sentences.\n\n" +
           head(titles) + rows;
}

std::string failures(const Trade& trade) {
    std::string text;
    for (const TradePoint& point : trade.points)
        if (!point.failure.empty()) text += "- " + nameOf(point) + ": " + point.failure + ".\n";
    for (const TradeLeftOut& left : trade.leftOut)
        text += "- " + left.axis + " " + left.setting + ": not run; it " + left.reason + ".\n";
    return text.empty() ? "" : "\n## Without a result\n\n" + text;
}

/// The presets that were measured, with the one to use.
std::string presetSection(const Trade& trade) {
    std::string text = "\n## Presets\n\n";
    const int best = recommendedPreset(trade, recommendedError);
    if (best < 0) text += "No preset is recommended: " + withoutRecommendation(trade, recommendedError) + ".\n\n";
    for (const std::size_t i : byTime(trade)) {
        if (!isPreset(trade.points[i])) continue;
        const std::string sentence = sentenceOn(trade, i);
        text += static_cast<int>(i) == best ? "- **" + sentence + " (recommended)**\n" : "- " + sentence + "\n";
    }
    return text;
}

std::string recommendation(const Trade& trade) {
    const int best = recommendedPoint(trade, recommendedError);
    const std::string most = changeText(recommendedError);
    if (best < 0) return "No settings are recommended: " + withoutRecommendation(trade, recommendedError) + ".\n";
    const TradePoint& point = trade.points[best];
    std::string text = "**" + sentenceOn(trade, best) +
                       ".**\n\nThese are the fastest settings with all quantities within " + most + " of the reference";
    if (point.overrides.empty()) return text + ".\n";
    text += ":\n\n    keyblock run SCENE.json --set";
    for (const std::string& set : point.overrides) text += " " + set;
    return text + "\n";
}

}  // namespace

void writeTradeTable(const Trade& trade, const Scene& scene, std::ostream& out) {
    CsvWriter csv(out);
    for (const char* column :
         {"axis", "setting", "quantity", "value", "error", "wall_s", "steps", "passes", "factorizations", "unknowns",
          "on_front", "preset", "order", "expected_error", "solves", "memory_MB", "blocks_moved", "scatter"})
        csv.text(column);
    csv.endRow();
    const auto optional = [&](const std::optional<double>& number) {
        if (number) csv.number(*number);
        else csv.text("");
    };
    for (std::size_t i = 0; i < trade.points.size(); ++i) {
        const TradePoint& point = trade.points[i];
        const bool onFront = isOnFront(trade, i);
        for (std::size_t q = 0; q < trade.quantities.size(); ++q) {
            const std::string& quantity = trade.quantities[q];
            const auto expected = std::find_if(scene.about.expected.begin(), scene.about.expected.end(),
                                               [&](const Expected& e) { return e.quantity == quantity; });
            csv.text(point.axis).text(point.setting).text(quantity);
            optional(point.values[q].value);
            optional(errorOf(point, trade.points[trade.reference], trade.quantities, q));
            csv.number(point.seconds).integer(point.steps).integer(point.passes).integer(point.work.factorizations);
            csv.integer(point.unknowns).integer(onFront ? 1 : 0).text(point.preset);
            csv.text(orderText(convergenceOrder(trade, point.axis, q), rounded));
            if (expected != scene.about.expected.end() && point.values[q].value)
                csv.number(expected->value == 0.0 ? *point.values[q].value
                                                  : std::abs(*point.values[q].value / expected->value - 1.0));
            else csv.text("");
            csv.integer(point.work.solves);
            optional(point.memory > 0.0 ? std::optional(point.memory / megabyte) : std::nullopt);
            csv.integer(point.blocksMoved).number(scatterOf(trade, q)).endRow();
        }
    }
}

std::string tradePage(const Trade& trade, const Scene& scene) {
    const TradePoint &own = trade.points.front(), &reference = trade.points[trade.reference];
    std::string text = "# Accuracy and time: " + (scene.title.empty() ? "untitled scene" : scene.title) + "\n\n";
    if (!own.failure.empty())
        return text + "The run with the scene's own settings has no result to compare with: " + own.failure + ".\n";
    if (trade.interrupted) text += "This trade was interrupted before all runs were made.\n\n";
    text += recommendation(trade) + "\n";
    text +=
        "Errors are differences from the run with the finest settings (" + nameOf(reference) + "; " +
        threeDigits(reference.seconds) +
        " s). Work is in full factorizations of a thousand blocks, as in `info --json`. "
        "On the front, no other settings are both faster and more accurate. All runs but those of *threads* use one "
        "thread, and their time is that of the processor.\n";
    if (trade.proposed) text += "\nThe scene names no `quantities`; these were chosen from its results.\n";
    return text + presetSection(trade) + "\n## Settings\n\n" + pointTable(trade) + orderTable(trade) + failures(trade);
}

}  // namespace keyblock
