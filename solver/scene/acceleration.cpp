// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/scene/acceleration.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace keyblock {

namespace {

constexpr double stepsAPeriod = 40.0;

double valueAt(const Sine& sine, double time) {
    return sine.amplitude * std::sin(2.0 * std::numbers::pi * sine.frequency * time + sine.phase);
}

double valueAt(const Acceleration& acceleration, double time) {
    if (acceleration.value)
        return *acceleration.value;
    return acceleration.sine ? valueAt(*acceleration.sine, time) : recordAt(acceleration.record, time);
}

double longestStepFor(const Acceleration& acceleration) {
    if (acceleration.sine)
        return 1.0 / (stepsAPeriod * acceleration.sine->frequency);
    const double spacing = spacingOf(acceleration.record);
    return spacing > 0.0 ? spacing : std::numeric_limits<double>::infinity();
}

}  // namespace

double recordAt(const Table& record, double time) {
    if (record.empty() || time < record.front().first || time > record.back().first)
        return 0.0;
    const auto after = std::upper_bound(record.begin(), record.end(), time,
                                        [](double t, const auto& row) { return t < row.first; });
    const auto& [t0, a0] = *std::prev(after);
    if (after == record.end() || time == t0)
        return a0;
    const auto& [t1, a1] = *after;
    return a0 + (time - t0) / (t1 - t0) * (a1 - a0);
}

Point accelerationAt(const Acceleration& acceleration, double time) {
    return acceleration.factor * valueAt(acceleration, time) * acceleration.axis.normalized();
}

Point bodyForceAt(const Stage& stage, double time) {
    Point force{0.0, 0.0};
    if (stage.bodyAcceleration)
        force += accelerationAt(*stage.bodyAcceleration, time);
    if (stage.baseAcceleration)
        force -= accelerationAt(*stage.baseAcceleration, time);
    return force;
}

Baseline baselineOf(const Table& record, double factor) {
    Baseline b;
    for (std::size_t i = 1; i < record.size(); ++i) {
        const double h = record[i].first - record[i - 1].first;
        const double a0 = factor * record[i - 1].second, a1 = factor * record[i].second;
        b.displacement += h * b.velocity + h * h * (2.0 * a0 + a1) / 6.0;
        b.velocity += 0.5 * h * (a0 + a1);
        b.peakVelocity = std::max(b.peakVelocity, std::abs(b.velocity));
        b.peakDisplacement = std::max(b.peakDisplacement, std::abs(b.displacement));
    }
    return b;
}

double spacingOf(const Table& record) {
    if (record.size() < 2)
        return 0.0;
    return (record.back().first - record.front().first) / static_cast<double>(record.size() - 1);
}

double longestStepFor(const Stage& stage) {
    double longest = std::numeric_limits<double>::infinity();
    for (const auto& acceleration : {&stage.baseAcceleration, &stage.bodyAcceleration})
        if (*acceleration)
            longest = std::min(longest, longestStepFor(**acceleration));
    return longest;
}

}  // namespace keyblock
