// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/stage/limit_search.h"

#include <algorithm>
#include <utility>

namespace keyblock {
namespace {

constexpr int halvingPatience = 3;  // tries in which the bracket must shrink to half its width; otherwise it is halved

// fraction of the bracket; a line that leads beyond it has already led to the high end
constexpr double nearHigh = 0.999;

/// Ratio of the limit in a list, at most 1; 0 if it is not in the list.
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

/// Point at which a limit that is exceeded at the high end reaches 1. It is extrapolated from the last two low ends if
/// that leads to a point inside the bracket, and otherwise interpolated between the low and the high end.
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
