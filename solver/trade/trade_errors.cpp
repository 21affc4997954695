// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/trade/trade_errors.h"

#include "solver/trade/change_text.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string_view>

namespace keyblock {

namespace {

// ratios from which a run is not cheaper: of work, of time with less work, and of time alone
constexpr double sameWork = 0.98, sameTime = 0.9, otherTime = 0.7;
constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double leastListed = 1e-4;  // smaller errors are not listed in sentences
constexpr double leastError = 1e-6;  // smaller errors are equal on the front
constexpr std::size_t mostCompared = 2000;  // events of an order; the comparison takes the square of that

bool isItselfAnError(const std::string& quantity) { return quantity == "energy_error"; }

/// Length of the longest common subsequence.
std::size_t commonLength(const std::vector<std::string>& a, const std::vector<std::string>& b) {
    std::vector<std::size_t> row(b.size() + 1, 0);
    for (const std::string& item : a) {
        std::size_t diagonal = 0;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t above = row[j + 1];
            row[j + 1] = item == b[j] ? diagonal + 1 : std::max(above, row[j]);
            diagonal = above;
        }
    }
    return row.back();
}

double orderError(std::vector<std::string> a, std::vector<std::string> b) {
    a.resize(std::min(a.size(), mostCompared));
    b.resize(std::min(b.size(), mostCompared));
    const std::size_t longest = std::max(a.size(), b.size());
    return longest == 0 ? 0.0 : 1.0 - static_cast<double>(commonLength(a, b)) / static_cast<double>(longest);
}

/// The number of unknowns and the step have errors of first order at kinks, of second where the solution is smooth;
/// penalties and tolerances have errors proportional to them.
TheoreticalOrders theoreticalOrders(const std::string& axis) {
    const bool proportional = axis == "penalty_ratio" || axis == "tolerance";
    return {1.0, proportional ? 1.0 : 2.0};
}

struct SizedPoint {
    double size = 0.0;
    const TradePoint* point = nullptr;
};

/// The points of an axis with sizes, and the scene's own settings if their size on it is known, from fine to coarse.
std::vector<SizedPoint> pointsAlong(const Trade& trade, const std::string& axis) {
    std::vector<SizedPoint> points;
    for (const TradePoint& point : trade.points)
        if (point.axis == axis && point.size > 0.0 && point.failure.empty()) points.push_back({point.size, &point});
    if (const auto own = trade.ownSizes.find(axis); own != trade.ownSizes.end())
        points.push_back({own->second, &trade.points.front()});
    std::sort(points.begin(), points.end(), [](const auto& a, const auto& b) { return a.size < b.size; });
    return points;
}

/// The deviation of a number with its sign.
double signedError(double value, double reference) {
    return reference == 0.0 ? value : (value - reference) / std::abs(reference);
}

std::string orderDeviation(const std::string& quantity, double error) {
    const std::string kind = quantity.substr(std::string("order ").size());
    return error == 0.0 ? ", same order of " + kind
                        : ", " + changeText(error) + " of the order of " + kind + " differs";
}

/// Part of a sentence on a number. \param scatter of its reference.
std::string deviation(const std::string& quantity, double value, double reference, double scatter) {
    const bool absolute = reference == 0.0;
    std::string text = ", " + quantity + " " +
                       (absolute ? threeDigits(value) + " instead of 0"
                                 : signedChangeText(signedError(value, reference)));
    if (scatter >= leastListed) text += " ± " + (absolute ? threeDigits(scatter) : changeText(scatter));
    return text;
}

/// The fastest of some points with an error of at most `most`, without the reference, whose own error is unknown; −1 if
/// there is none.
template <typename Choice>
int fastest(const Trade& trade, double most, const Choice& isChosen) {
    int best = -1;
    for (std::size_t i = 0; i < trade.points.size(); ++i) {
        if (static_cast<int>(i) == trade.reference || !isChosen(trade.points[i])) continue;
        const bool good = largestError(trade.points[i], trade.points[trade.reference], trade.quantities) <= most;
        if (good && (best < 0 || trade.points[i].seconds < trade.points[best].seconds)) best = static_cast<int>(i);
    }
    return best;
}

}  // namespace

bool isCounted(const std::string& quantity) { return quantity.starts_with("count ") || quantity == "stands"; }

std::optional<double> errorOf(const TradePoint& point, const TradePoint& reference,
                              const std::vector<std::string>& quantities, std::size_t q) {
    if (isItselfAnError(quantities[q])) return std::nullopt;
    const Measurement &here = point.values[q], &there = reference.values[q];
    if (!here.order.empty() || !there.order.empty()) return orderError(here.order, there.order);
    if (!here.value && !there.value) return 0.0;
    if (!here.value || !there.value) return std::nullopt;
    return std::abs(signedError(*here.value, *there.value));
}

double largestError(const TradePoint& point, const TradePoint& reference, const std::vector<std::string>& quantities) {
    if (!point.failure.empty()) return infinite;
    double largest = 0.0;
    for (std::size_t q = 0; q < quantities.size(); ++q)
        if (!isItselfAnError(quantities[q]))
            largest = std::max(largest, errorOf(point, reference, quantities, q).value_or(infinite));
    return largest;
}

ConvergenceOrder convergenceOrder(const Trade& trade, const std::string& axis, std::size_t q) {
    std::vector<SizedValue> values;
    for (const SizedPoint& sized : pointsAlong(trade, axis)) {
        const std::optional<double>& value = sized.point->values[q].value;
        if (!value) break;  // coarser settings may miss an event
        values.push_back({sized.size, *value});
    }
    return convergenceOf(values, theoreticalOrders(axis));
}

double scatterOf(const Trade& trade, std::size_t q) {
    const std::optional<double>& reference = trade.points[trade.reference].values[q].value;
    if (!reference || isCounted(trade.quantities[q]) || isItselfAnError(trade.quantities[q])) return 0.0;
    std::set<std::string> axes;
    for (const TradePoint& point : trade.points)
        if (point.size > 0.0) axes.insert(point.axis);
    double sum = 0.0;
    for (const std::string& axis : axes) sum += convergenceOrder(trade, axis, q).scatter;
    return *reference == 0.0 ? sum : sum / std::abs(*reference);
}

bool isOnFront(const Trade& trade, std::size_t point) {
    const TradePoint& reference = trade.points[trade.reference];
    const double error = largestError(trade.points[point], reference, trade.quantities);
    if (std::isinf(error) || trade.points[point].axis == bondAxisName) return false;
    return std::none_of(trade.points.begin(), trade.points.end(), [&](const TradePoint& other) {
        const double itsError = largestError(other, reference, trade.quantities);
        return other.axis != bondAxisName && itsError <= std::max(error, leastError) &&
               other.seconds < trade.points[point].seconds;
    });
}

int recommendedPoint(const Trade& trade, double most) {
    return fastest(trade, most, [](const TradePoint& point) { return point.axis != bondAxisName; });
}

bool isPreset(const TradePoint& point) { return point.axis == presetAxisName || point.axis == ownPoint; }

bool isCheaper(const TradePoint& point, const TradePoint& own) {
    const bool timeAlone = point.axis == sleepAxisName || point.axis == threadsAxisName;
    const bool less = workOf(point.work) < sameWork * workOf(own.work) || point.unknowns < own.unknowns;
    return less ? point.seconds < sameTime * own.seconds : timeAlone && point.seconds < otherTime * own.seconds;
}

int recommendedPreset(const Trade& trade, double most) {
    const TradePoint &own = trade.points.front(), &reference = trade.points[trade.reference];
    const bool ownIsGood = largestError(own, reference, trade.quantities) <= most;
    return fastest(trade, most, [&](const TradePoint& point) {
        return isPreset(point) && (!ownIsGood || point.axis == ownPoint || isCheaper(point, own));
    });
}

std::string withoutRecommendation(const Trade& trade, double most) {
    if (trade.reference == 0)
        return "nothing finer than the scene's own settings was run, so that their error is unknown";
    return "none of the settings gives all quantities within " + changeText(most) + " of the finest run";
}

std::string nameOf(const TradePoint& point) {
    if (point.axis == ownPoint) return point.axis + (point.preset.empty() ? "" : " (" + point.preset + ")");
    if (point.axis == presetAxisName) return point.setting;
    if (point.axis == combinationPoint) return point.setting;
    return point.axis + (point.axis == referencePoint ? ": " : " ") + point.setting;
}

std::string sentenceOn(const Trade& trade, std::size_t index) {
    const TradePoint &point = trade.points[index], &own = trade.points.front(),
                     &reference = trade.points[trade.reference];
    std::string text = nameOf(point) + ": ";
    if (index != 0) {
        const double faster = own.seconds / point.seconds;
        const std::string than = " than " + (point.axis == presetAxisName ? own.preset : "the scene's own settings");
        text += faster >= 1.0 ? timesText(faster) + " faster" + than : timesText(1.0 / faster) + " slower" + than;
    } else {
        text += threeDigits(point.seconds) + " s";
    }
    bool listed = false, others = false;  // others: with errors too small to be listed
    bool scattered = false;
    for (std::size_t q = 0; q < trade.quantities.size(); ++q) {
        const auto error = errorOf(point, reference, trade.quantities, q);
        if (!error) continue;
        const bool isOrder = !point.values[q].order.empty() || !reference.values[q].order.empty();
        const double scatter = isOrder ? 0.0 : scatterOf(trade, q);
        if (!isOrder && *error < leastListed && scatter < leastListed) {
            others = others || point.values[q].value;
            continue;
        }
        text += isOrder ? orderDeviation(trade.quantities[q], *error)
                        : deviation(trade.quantities[q], *point.values[q].value, *reference.values[q].value, scatter);
        listed = true;
        scattered = scattered || scatter >= leastListed;
    }
    if (others) text += (listed ? ", all else within " : ", all quantities within ") + changeText(leastListed);
    return text + (scattered ? " (±: not regular)" : "");
}

}  // namespace keyblock
