// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The search for the first limit on ratios that bend and jump as those of bolts do.
#include "solver/engine/stage/limit_search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace keyblock {
namespace {

using Ratio = std::function<double(double)>;

struct Found {
    double share = 0.0;
    int tries = 0;
};

/// Looks in [0, 1] until the largest ratio is 1 to the share that events are located to, or nothing is left between.
Found searched(const std::vector<Ratio>& ratios) {
    const auto at = [&](double share) {
        std::vector<Limit> limits;
        for (std::size_t i = 0; i < ratios.size(); ++i)
            limits.push_back({LimitKind::Yield, 0, static_cast<int>(i), ratios[i](share)});
        return limits;
    };
    LimitSearch search(0.0, at(0.0), 1.0, at(1.0));
    Found found;
    while (search.width() > 1e-12) {
        found.share = search.next();
        ++found.tries;
        std::vector<Limit> limits = at(found.share);
        double worst = 0.0;
        for (const Limit& limit : limits) worst = std::max(worst, limit.ratio);
        if (std::abs(worst - 1.0) <= reachedShare || found.tries > 200) return found;
        search.take(found.share, std::move(limits), worst > 1.0);
    }
    return found;
}

/// 1 at `share`, rising by `before` up to there and by `after` from there.
Ratio bent(double share, double before, double after) {
    return [=](double t) { return 1.0 + (t < share ? before : after) * (t - share); };
}

TEST(LimitSearch, FindsAStraightLineAtOnce) {
    const Found found = searched({bent(0.3, 2.0, 2.0)});
    EXPECT_NEAR(found.share, 0.3, 1e-9);
    EXPECT_EQ(found.tries, 1);
}

// Steel flows a thousand times faster than it stretches: what lies past the limit says nothing of where it is.
TEST(LimitSearch, IsNotLedAstrayByWhatFlows) {
    const Found found = searched({bent(0.7, 0.01, 10.0), bent(0.72, 0.01, 30.0), bent(0.9, 0.2, 5.0)});
    EXPECT_NEAR(found.share, 0.7, 1e-7);  // reachedShare over the slope
    EXPECT_LE(found.tries, 5);
}

TEST(LimitSearch, FollowsACurveOnEitherSide) {
    for (const double power : {0.2, 3.0}) {
        const Found found = searched({[=](double t) { return 2.0 * std::pow(t, power); }});
        EXPECT_NEAR(found.share, std::pow(0.5, 1.0 / power), 1e-8) << power;
        EXPECT_LE(found.tries, 12) << power;
    }
}

TEST(LimitSearch, ClosesInOnAJump) {
    for (const double share : {1e-6, 0.4, 0.99}) {
        const Found found = searched({[=](double t) { return t < share ? 0.5 : 3.0; }});
        EXPECT_NEAR(found.share, share, 1e-11) << share;
        EXPECT_LE(found.tries, 80) << share;
    }
}

}  // namespace
}  // namespace keyblock
