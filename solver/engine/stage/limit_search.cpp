// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/stage/limit_search.h"

#include <algorithm>
#include <utility>

namespace keyblock {
namespace {

constexpr int halvingPatience = 3;  // tries in which the two ends come to half their distance, or it is halved

constexpr double nearHigh = 0.999;  // of the way: so near to the high end that this line has led there before

/// The limit's ratio in a list, at most 1; 0 where the list has none.
double ratioIn(const std::vector<Limit>& limits, const Limit& limit) {
    const auto same = std::find_if(limits.begin(), limits.end(), [&](const Limit& l) { return sameLimit(l, limit); });
    return same == limits.end() ? 0.0 : std::min(same->ratio, 1.0);
}

}  // namespace

LimitSearch::LimitSearch(double low, std::vector<Limit> atLow, double high, std::vector<Limit> atHigh)
    : low_{low, std::move(atLow)}, high_{high, std::move(atHigh)}, width_(high - low) {}

double LimitSearch::next() {
    if (++tries_ % halvingPatience == 0) {
        const bool halve = width() > 0.5 * width_;
        width_ = width();
        if (halve) return low_.share + 0.5 * width();
    }
    double first = high_.share;
    for (const Limit& limit : high_.limits)
        if (limit.ratio > 1.0) first = std::min(first, crossing(limit));
    return first;
}

/// Where a limit that is over at the high end passes 1: on the line through the last two low ends, where that leads to
/// a place between the ends, else on the line between them.
double LimitSearch::crossing(const Limit& over) const {
    const double atLow = ratioIn(low_.limits, over), left = 1.0 - atLow;
    if (!before_.limits.empty()) {
        const double rise = atLow - ratioIn(before_.limits, over);
        const double on = rise > 0.0 ? left / rise * (low_.share - before_.share) : width();
        if (on < nearHigh * width()) return low_.share + on;
    }
    const double a = low_.weight * left, b = high_.weight * (over.ratio - 1.0);
    return low_.share + a / (a + b) * width();
}

void LimitSearch::take(double share, std::vector<Limit> limits, bool over) {
    if (!over) before_ = std::move(low_);
    (over ? high_ : low_) = {share, std::move(limits)};
    const int now = over ? 1 : -1;
    if (now == moved_) (over ? low_ : high_).weight *= 0.5;
    moved_ = now;
}

}  // namespace keyblock
