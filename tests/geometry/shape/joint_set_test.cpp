// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Joint sets without deviations stand where arithmetic puts them; with
// deviations their means and spreads are those asked for; and nothing but the
// clipping knows the region.
#include "geometry/shape/joint_set.h"

#include "geometry/angle.h"
#include "geometry/polygon.h"
#include "geometry/segment.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>

namespace keyblock {
namespace {

using Region = std::vector<Point>;

constexpr double traceTolerance = 1e-9;

Region box(double left, double bottom, double right, double top) {
    return {{left, bottom}, {right, bottom}, {right, top}, {left, top}};
}

double lengthOf(const JointTrace& trace) { return (trace.segment.to - trace.segment.from).norm(); }

std::map<std::pair<std::int64_t, std::int64_t>, Segment> byNumber(const std::vector<JointTrace>& traces) {
    std::map<std::pair<std::int64_t, std::int64_t>, Segment> named;
    for (const JointTrace& trace : traces) named.try_emplace({trace.line, trace.number}, trace.segment);
    return named;
}

/// The traces of `few` that lie clear of the border of `region` are in `many`, to the last digit.
void expectKept(const std::vector<JointTrace>& few, const std::vector<JointTrace>& many, const Region& region) {
    const auto named = byNumber(many);
    int compared = 0;
    for (const JointTrace& trace : few) {
        if (locate(region, trace.segment.from, 1e-6) != Side::Inside) continue;
        if (locate(region, trace.segment.to, 1e-6) != Side::Inside) continue;
        const auto found = named.find({trace.line, trace.number});
        ASSERT_NE(found, named.end());
        EXPECT_EQ(found->second, trace.segment);
        ++compared;
    }
    EXPECT_GT(compared, 20);
}

TEST(JointSet, ThroughJointsStandOneSpacingApart) {
    JointSet set;
    set.spacing = {0.5, 0.0};
    set.origin = {3.0, 0.25};
    const auto traces = jointTraces(set, box(-2, 0, 4, 2), traceTolerance);
    ASSERT_EQ(traces.size(), 4u);  // at y = 0.25, 0.75, 1.25, 1.75
    for (std::size_t i = 0; i < traces.size(); ++i) {
        EXPECT_EQ(traces[i].line, static_cast<std::int64_t>(i));
        EXPECT_EQ(traces[i].segment.from, Point(-2, 0.25 + 0.5 * static_cast<double>(i)));
        EXPECT_EQ(traces[i].segment.to, Point(4, 0.25 + 0.5 * static_cast<double>(i)));
    }
}

TEST(JointSet, OnBordersTheyCount) {
    JointSet set;
    set.dip = 90.0;
    const auto traces = jointTraces(set, box(-2, 0, 3, 1), traceTolerance);
    ASSERT_EQ(traces.size(), 6u);
    EXPECT_EQ(traces.front().segment, (Segment{{3, 0}, {3, 1}}));  // left of a dip that points upward is line 1
    EXPECT_EQ(traces.back().segment, (Segment{{-2, 0}, {-2, 1}}));
}

TEST(JointSet, OneJointPassesThroughTheOrigin) {
    for (const double dip : {-70.0, 0.0, 35.0, 90.0, 123.4}) {
        JointSet set;
        set.dip = dip;
        set.dipDeviation = 5.0;
        set.spacing = {1.2, 0.4};
        set.origin = {0.7, -0.3};
        set.seed = 5;
        for (const bool through : {true, false}) {
            if (!through) set.length = Scatter{2.0, 0.5}, set.bridge = {1.0, 0.2};
            const auto named = byNumber(jointTraces(set, box(-5, -5, 5, 5), traceTolerance));
            const Segment& own = named.at({0, 0});
            EXPECT_LT(distanceToSegment(own.from, own.to, set.origin), 1e-14);
        }
    }
}

TEST(JointSet, TracesAndBridgesAlternate) {
    JointSet set;
    set.length = Scatter{2.0, 0.0};
    set.bridge = {1.0, 0.0};
    set.stagger = 0.5;
    const auto named = byNumber(jointTraces(set, box(-7, -0.5, 7, 1.5), traceTolerance));
    EXPECT_EQ(named.at({0, 0}), (Segment{{-1, 0}, {1, 0}}));
    EXPECT_EQ(named.at({0, 1}), (Segment{{2, 0}, {4, 0}}));
    EXPECT_EQ(named.at({0, -2}), (Segment{{-7, 0}, {-5, 0}}));
    EXPECT_EQ(named.at({1, 0}).from.y(), 1.0);
    const double shift = std::remainder(named.at({1, 0}).from.x() + 1.0, 3.0);
    EXPECT_NEAR(std::abs(shift), 1.5, 1e-12);
    EXPECT_EQ(named.size(), 11u);  // five on the line of the origin, six on the other, two of them cut off
}

TEST(JointSet, ALargerRegionAddsTracesAndChangesNone) {
    JointSet set;
    set.dip = 35.0;
    set.dipDeviation = 6.0;
    set.spacing = {0.7, 0.3};
    set.length = Scatter{1.5, 0.6};
    set.bridge = {0.6, 0.4};
    set.stagger = std::nullopt;
    set.seed = 42;
    const Region small = box(-5, -4, 6, 5);
    const auto few = jointTraces(set, small, traceTolerance);
    expectKept(few, jointTraces(set, box(-50, -30, 20, 70), traceTolerance), small);
    expectKept(few, jointTraces(set, Region{{-9, -8}, {30, -9}, {40, 40}, {-8, 12}}, traceTolerance), small);
}

TEST(JointSet, NoTraceNearTheRegionIsForgotten) {
    JointSet set;
    set.dip = -20.0;
    set.dipDeviation = 20.0;
    set.spacing = {0.5, 0.2};
    set.length = Scatter{4.0, 3.0};
    const Region small = box(10, 8, 12, 10);
    const auto wide = jointTraces(set, box(-20, -20, 40, 40), traceTolerance);
    const auto found = byNumber(jointTraces(set, small, traceTolerance));
    int meeting = 0;
    for (const JointTrace& trace : wide) {
        const double length = lengthOf(trace);
        const Point along = (trace.segment.to - trace.segment.from) / length;
        if (clipped(small, trace.segment.from, along, 0.0, length, 1e-6).empty()) continue;
        EXPECT_TRUE(found.contains({trace.line, trace.number})) << trace.line << " " << trace.number;
        ++meeting;
    }
    EXPECT_GT(meeting, 5);
}

TEST(JointSet, GoesOnBehindANotchOnTheSameLine) {
    const Region notched{{0, 0}, {10, 0}, {10, 5}, {6, 5}, {6, 1}, {4, 1}, {4, 5}, {0, 5}};
    JointSet set;
    set.dip = 10.0;
    set.origin = {0.0, 1.5};
    set.spacing = {100.0, 0.0};
    const auto traces = jointTraces(set, notched, traceTolerance);
    ASSERT_EQ(traces.size(), 2u);
    EXPECT_NEAR(traces[0].segment.to.x(), 4.0, 1e-12);
    EXPECT_NEAR(traces[1].segment.from.x(), 6.0, 1e-12);
    for (const JointTrace& trace : traces)
        for (const Point& p : {trace.segment.from, trace.segment.to})
            EXPECT_NEAR(cross(directionOf(10.0), p - set.origin), 0.0, 1e-14);
}

TEST(JointSet, ScatterHasItsMeansAndDeviations) {
    JointSet set;
    set.spacing = {0.5, 0.2};
    set.dipDeviation = 4.0;
    set.length = Scatter{1.0, 0.3};
    set.bridge = {0.5, 0.2};
    set.seed = 8;
    const auto traces = jointTraces(set, box(-50, -50, 50, 50), traceTolerance);
    ASSERT_GT(traces.size(), 10000u);
    std::map<std::int64_t, double> across;
    double dips = 0.0, squares = 0.0, lengths = 0.0;
    int whole = 0;
    for (const JointTrace& trace : traces) {
        const Point middle = 0.5 * (trace.segment.from + trace.segment.to);
        if (std::abs(middle.x()) > 48.0 || std::abs(middle.y()) > 48.0) continue;
        across[trace.line] = middle.y();
        const Point d = trace.segment.to - trace.segment.from;
        const double dip = std::atan2(d.y(), d.x()) / radiansPerDegree;
        EXPECT_LT(std::abs(dip), scatterCut * set.dipDeviation * (1.0 + 1e-12));
        dips += dip;
        squares += dip * dip;
        lengths += lengthOf(trace);
        ++whole;
    }
    const double root = std::sqrt(whole);
    EXPECT_NEAR(dips / whole, 0.0, 4.0 * 4.0 / root);
    EXPECT_NEAR(std::sqrt(squares / whole), 0.98658 * 4.0, 0.1);  // the share that a cut at three deviations leaves
    EXPECT_NEAR(lengths / whole, 1.0, 4.0 * 0.3 / root);
    const double lines = static_cast<double>(across.size());
    EXPECT_NEAR((across.rbegin()->second - across.begin()->second) / (lines - 1), 0.5, 4.0 * 0.2 / std::sqrt(lines));
    EXPECT_NEAR(lengths / (96.0 * lines), 1.0 / 1.5, 0.02);  // persistence: length / (length + bridge)
}

TEST(JointSet, ADeviationLeavesTheOtherDrawsAlone) {
    JointSet set;
    set.spacing = {0.5, 0.2};
    set.length = Scatter{1.0, 0.3};
    set.bridge = {0.5, 0.2};
    const Region region = box(-10, -10, 10, 10);
    const auto straight = byNumber(jointTraces(set, region, traceTolerance));
    set.dipDeviation = 3.0;
    const auto turned = byNumber(jointTraces(set, region, traceTolerance));
    int compared = 0;
    for (const auto& [number, a] : straight) {
        const auto found = turned.find(number);
        if (found == turned.end() || (a.from + a.to).cwiseAbs().maxCoeff() > 16.0) continue;
        const Segment& b = found->second;
        EXPECT_LT((a.from + a.to - b.from - b.to).norm(), 1e-12);
        EXPECT_NEAR((a.to - a.from).norm(), (b.to - b.from).norm(), 1e-12);
        ++compared;
    }
    EXPECT_GT(compared, 100);
}

TEST(JointSet, ASeedMeansTheSameTracesForEver) {
    JointSet set;
    set.dip = 35.0;
    set.dipDeviation = 5.0;
    set.spacing = {1.2, 0.4};
    set.length = Scatter{2.0, 0.5};
    set.bridge = {1.0, 0.3};
    set.stagger = std::nullopt;
    set.seed = 7;
    const auto named = byNumber(jointTraces(set, box(-20, -20, 20, 20), traceTolerance));
    // From the same rules written in another language.
    const auto expectTrace = [&](std::int64_t line, std::int64_t number, const Segment& expected) {
        const Segment& found = named.at({line, number});
        EXPECT_LT((found.from - expected.from).norm(), 1e-12);
        EXPECT_LT((found.to - expected.to).norm(), 1e-12);
    };
    expectTrace(2, 1, {{1.345199535622303, 4.2617303710528445}, {2.8367852947124508, 5.4556611263719299}});
    expectTrace(-3, -2, {{-4.7841820365908188, -7.7621910098649662}, {-2.8808607145419081, -6.5305958018771131}});
    set.seed = 8;
    const auto others = byNumber(jointTraces(set, box(-20, -20, 20, 20), traceTolerance));
    EXPECT_GT((others.at({2, 1}).from - named.at({2, 1}).from).norm(), 1e-3);
}

TEST(JointSet, FarFromTheOriginRegularJointsAreFoundAtOnce) {
    JointSet set;
    set.dip = 90.0;
    set.length = Scatter{2.0, 0.0};
    set.bridge = {2.0, 0.0};
    const Region far = box(1e6, 1e6, 1e6 + 4, 1e6 + 4);
    EXPECT_LT(jointTraceEstimate(set, far), 30.0);
    const auto traces = jointTraces(set, far, traceTolerance);
    ASSERT_EQ(traces.size(), 10u);  // two halves of traces on each of five lines
    for (const JointTrace& trace : traces) EXPECT_NEAR(lengthOf(trace), 1.0, traceTolerance);
}

TEST(JointSet, MovedWithItsRegionItIsTheSame) {
    JointSet set;
    set.dip = 25.0;
    set.dipDeviation = 5.0;
    set.spacing = {0.5, 0.2};
    set.length = Scatter{1.0, 0.3};
    const auto here = jointTraces(set, box(-4, -4, 4, 4), traceTolerance);
    const Point moved(1e6, -2e6);
    set.origin += moved;
    Region region = box(-4, -4, 4, 4);
    for (Point& p : region) p += moved;
    const auto there = jointTraces(set, region, traceTolerance);
    ASSERT_EQ(here.size(), there.size());
    for (std::size_t i = 0; i < here.size(); ++i) {
        EXPECT_LT((there[i].segment.from - moved - here[i].segment.from).norm(), 1e-8);
        EXPECT_LT((there[i].segment.to - moved - here[i].segment.to).norm(), 1e-8);
    }
}

TEST(JointSet, TheEstimateForeseesTheWork) {
    const Region kilometre = box(0, 0, 1000, 1000);
    JointSet set;
    set.spacing = {1e-6, 0.0};
    EXPECT_GT(jointTraceEstimate(set, kilometre), 1e9);
    set.spacing = {1.0, 0.0};
    set.length = Scatter{1e-6, 0.0};
    EXPECT_GT(jointTraceEstimate(set, kilometre), 1e11);
    set.spacing = {1.0, 0.5};
    set.length = Scatter{3.0, 1.0};
    set.bridge = {1.0, 0.0};
    set.origin = {500.0, 500.0};
    const double estimate = jointTraceEstimate(set, box(400, 400, 600, 600));
    const auto made = static_cast<double>(jointTraces(set, box(400, 400, 600, 600), traceTolerance).size());
    EXPECT_NEAR(made / estimate, 1.0, 0.1);
    set.origin = {-1e6, 0.0};
    EXPECT_GT(jointTraceEstimate(set, kilometre), 1e8) << "every trace from the origin on has to be numbered";
}

TEST(JointSet, ProblemsNameTheField) {
    const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
    EXPECT_FALSE(jointSetProblem(JointSet{}));
    const auto field = [](auto change) {
        JointSet set;
        set.length = Scatter{1.0, 0.0};
        change(set);
        const auto problem = jointSetProblem(set);
        return problem ? problem->field : std::string("none");
    };
    for (const double bad : {0.0, -1.0, nan, infinity}) {
        EXPECT_EQ(field([&](JointSet& s) { s.spacing.mean = bad; }), "spacing");
        EXPECT_EQ(field([&](JointSet& s) { s.length->mean = bad; }), "trace_length");
    }
    for (const double bad : {-1.0, nan, infinity}) {
        EXPECT_EQ(field([&](JointSet& s) { s.bridge.mean = bad; }), "bridge");
        EXPECT_EQ(field([&](JointSet& s) { s.spacing.deviation = bad; }), "spacing_deviation");
        EXPECT_EQ(field([&](JointSet& s) { s.length->deviation = bad; }), "trace_length_deviation");
        EXPECT_EQ(field([&](JointSet& s) { s.dipDeviation = bad; }), "dip_deviation");
    }
    EXPECT_EQ(field([&](JointSet& s) { s.bridge.deviation = 0.1; }), "bridge_deviation");
    EXPECT_EQ(field([&](JointSet& s) { s.dip = nan; }), "dip");
    EXPECT_EQ(field([&](JointSet& s) { s.dipDeviation = 26.0; }), "dip_deviation");
    EXPECT_EQ(field([&](JointSet& s) { s.stagger = infinity; }), "stagger");
    EXPECT_EQ(field([&](JointSet& s) { s.origin.x() = nan; }), "origin");
    EXPECT_EQ(field([&](JointSet& s) { s.stagger = std::nullopt; }), "none");
}

}  // namespace
}  // namespace keyblock
