// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The position of a joint is its number times the mean spacing plus the sum of all deviations so far. Without
// deviations, positions have no accumulated round-off, and a line far from the origin is found without stepping through
// the lines before it.
#include "geometry/shape/joint_set.h"

#include "geometry/angle.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <string>
#include <tuple>

namespace keyblock {
namespace {

/// The quantity for which a random stream is drawn. It is part of the stream's name, so that adding one deviation does
/// not change the random numbers of the others.
enum Purpose : std::int64_t { Spacing, Dip, Length, Bridge, Shift };

/// Extent of the region in the frame of the joint set. Across the joints, it includes the distance by which the middle
/// of a trace may lie outside the region.
struct Reach {
    double lowAlong = 0.0, highAlong = 0.0;  // [m]
    double lowAcross = 0.0, highAcross = 0.0;  // of joints that can reach the region [m]
};

double largestTurn(const JointSet& set) { return scatterCut * set.dipDeviation * radiansPerDegree; }

Reach reachOf(const JointSet& set, std::span<const Point> region) {
    const Point along = directionOf(set.dip);
    const Point first = region.front() - set.origin;
    Reach reach{along.dot(first), along.dot(first), cross(along, first), cross(along, first)};
    for (const Point& corner : region) {
        const Point p = corner - set.origin;
        reach.lowAlong = std::min(reach.lowAlong, along.dot(p));
        reach.highAlong = std::max(reach.highAlong, along.dot(p));
        reach.lowAcross = std::min(reach.lowAcross, cross(along, p));
        reach.highAcross = std::max(reach.highAcross, cross(along, p));
    }
    const double turned = set.length ? 0.5 * largest(*set.length) * std::sin(largestTurn(set))
                                     : std::max(-reach.lowAlong, reach.highAlong) * std::tan(largestTurn(set));
    reach.lowAcross -= turned;
    reach.highAcross += turned;
    return reach;
}

double period(const JointSet& set) { return set.length->mean + set.bridge.mean; }

bool tracesScatter(const JointSet& set) { return set.length->deviation > 0.0 || set.bridge.deviation > 0.0; }

/// First number to visit: 0 or 1 if the deviations of all numbers have to be summed, otherwise the last number before
/// `low`.
std::int64_t firstNumber(bool scatters, int side, double low, double step) {
    const std::int64_t first = side > 0 ? 0 : 1;
    if (scatters || low <= step) return first;
    return std::max(first, static_cast<std::int64_t>(std::floor(low / step)));
}

/// Calls visit(line, position across the set [m]) for every line between `low` and `high`.
template <class Visit>
void forEachLine(const JointSet& set, double low, double high, Visit visit) {
    const bool scatters = set.spacing.deviation > 0.0;
    for (const int side : {1, -1}) {
        const double near = side > 0 ? low : -high;
        const double far = side > 0 ? high : -low;
        double drift = 0.0;
        for (std::int64_t k = firstNumber(scatters, side, near, set.spacing.mean);; ++k) {
            if (scatters && k > 0) {
                Random random(set.seed, {side * k, Spacing});
                drift += draw(random, set.spacing) - set.spacing.mean;
            }
            const double place = static_cast<double>(k) * set.spacing.mean + drift;
            if (place > far) break;
            if (place >= near) visit(side * k, side * place);
        }
    }
}

/// Position of the middle of trace 0 along its line [m].
double middleOfLine(const JointSet& set, std::int64_t line) {
    if (line == 0) return 0.0;
    Random random(set.seed, {line, Shift});
    const double shift = set.stagger ? *set.stagger * static_cast<double>(line) : random.uniform() - 0.5;
    return period(set) * std::remainder(shift, 1.0);
}

/// Calls visit(number, middle along the line [m], length [m]) for every trace of a line that meets the interval from
/// `low` to `high`.
template <class Visit>
void forEachTrace(const JointSet& set, std::int64_t line, double low, double high, Visit visit) {
    const auto drawn = [&](const Scatter& scatter, Purpose purpose, std::int64_t number) {
        Random random(set.seed, {line, purpose, number});
        return draw(random, scatter);
    };
    const double start = middleOfLine(set, line);
    const double half = 0.5 * largest(*set.length);
    for (const int side : {1, -1}) {
        const double near = side > 0 ? low : -high;
        const double far = side > 0 ? high : -low;
        double drift = side * start, before = drawn(*set.length, Length, 0);
        for (std::int64_t k = firstNumber(tracesScatter(set), side, near - half - drift, period(set));; ++k) {
            const double length = drawn(*set.length, Length, side * k);
            if (k > 0) {
                const double bridge = drawn(set.bridge, Bridge, side * k);
                drift += 0.5 * (before + length) - set.length->mean + bridge - set.bridge.mean;
            }
            before = length;
            const double middle = static_cast<double>(k) * period(set) + drift;
            if (middle - half > far) break;
            if (middle + 0.5 * length >= near && middle - 0.5 * length <= far)
                visit(side * k, side * middle, length);
        }
    }
}

bool isScatter(const Scatter& scatter) {
    return std::isfinite(scatter.mean) && scatter.deviation >= 0.0 &&
           scatter.deviation <= largestDeviationRatio * scatter.mean;
}

std::optional<ShapeProblem> scatterProblem(const Scatter& scatter, const std::string& field) {
    if (isScatter(scatter)) return std::nullopt;
    return ShapeProblem{field + "_deviation", "the deviation must lie between 0 and twice the mean",
                        "give a standard deviation in metres; 0 for none"};
}

}  // namespace

std::optional<ShapeProblem> jointSetProblem(const JointSet& set) {
    if (!std::isfinite(set.dip)) return ShapeProblem{"dip", "the dip is not a finite number", "give degrees"};
    if (!(set.dipDeviation >= 0.0 && set.dipDeviation <= largestDipDeviation))
        return ShapeProblem{"dip_deviation", "the deviation of the dip must lie between 0 and 25 degrees",
                            "use several joint sets for directions that differ more"};
    if (!(set.spacing.mean > 0.0 && std::isfinite(set.spacing.mean)))
        return ShapeProblem{"spacing", "the spacing must be above 0", "give the distance between joints in metres"};
    if (set.length && !(set.length->mean > 0.0 && std::isfinite(set.length->mean)))
        return ShapeProblem{"trace_length", "the length of a trace must be above 0",
                            "give metres, or null for joints through the whole region"};
    if (!(set.bridge.mean >= 0.0 && std::isfinite(set.bridge.mean)))
        return ShapeProblem{"bridge", "the bridge between traces must not be negative", "give metres, or 0"};
    if (set.stagger && !std::isfinite(*set.stagger))
        return ShapeProblem{"stagger", "the stagger is not a finite number", "give a share of trace and bridge"};
    if (!set.origin.allFinite())
        return ShapeProblem{"origin", "the origin is not a finite point", "give a point that one joint passes through"};
    if (auto problem = scatterProblem(set.spacing, "spacing")) return problem;
    if (set.length)
        if (auto problem = scatterProblem(*set.length, "trace_length")) return problem;
    return scatterProblem(set.bridge, "bridge");
}

double jointTraceEstimate(const JointSet& set, std::span<const Point> region) {
    assert(!jointSetProblem(set) && !region.empty());
    /// Number of steps from `low` to `high`; with scatter, the interval is extended to include 0.
    const auto steps = [](bool scatters, double low, double high, double step) {
        return 1.0 + (scatters ? std::max(high, 0.0) - std::min(low, 0.0) : high - low) / step;
    };
    const Reach reach = reachOf(set, region);
    const double numbered =
        steps(set.spacing.deviation > 0.0, reach.lowAcross, reach.highAcross, set.spacing.mean);
    const double drawn = steps(false, reach.lowAcross, reach.highAcross, set.spacing.mean);
    const double onOne = set.length ? steps(tracesScatter(set), reach.lowAlong, reach.highAlong, period(set)) : 1.0;
    return numbered + drawn * onOne;
}

std::vector<JointTrace> jointTraces(const JointSet& set, std::span<const Point> region, double tolerance) {
    assert(!jointSetProblem(set));
    const Point along = directionOf(set.dip);
    const Reach reach = reachOf(set, region);
    std::vector<JointTrace> traces;
    const auto add = [&](std::int64_t line, std::int64_t number, const Point& middle, double half) {
        double turn = 0.0;
        if (set.dipDeviation > 0.0)
            turn = set.dipDeviation * Random(set.seed, {line, Dip, number}).normalWithin(scatterCut);
        const Point direction = directionOf(set.dip + turn);
        for (const auto& [begin, end] : clipped(region, middle, direction, -half, half, tolerance))
            traces.push_back({{middle + begin * direction, middle + end * direction}, line, number});
    };
    forEachLine(set, reach.lowAcross - tolerance, reach.highAcross + tolerance, [&](std::int64_t line, double across) {
        const Point foot = set.origin + across * turnLeft(along);
        if (!set.length) {
            double farthest = 0.0;
            for (const Point& corner : region) farthest = std::max(farthest, (corner - foot).norm());
            add(line, 0, foot, 2.0 * farthest);
            return;
        }
        forEachTrace(set, line, reach.lowAlong, reach.highAlong,
                     [&](std::int64_t number, double middle, double length) {
                         add(line, number, foot + middle * along, 0.5 * length);
                     });
    });
    std::stable_sort(traces.begin(), traces.end(), [](const JointTrace& a, const JointTrace& b) {
        return std::tie(a.line, a.number) < std::tie(b.line, b.number);
    });
    return traces;
}

}  // namespace keyblock
