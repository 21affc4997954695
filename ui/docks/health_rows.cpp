// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Values of the solver measures at a time, and their limits.
#include "solver/scene/preset.h"
#include "ui/docks/health_strip.h"
#include "ui/runs/live_run.h"

#include <algorithm>
#include <cmath>

namespace keyblock {

namespace {

// relative to the block size; relative to the largest energy
constexpr double penetrationLimit = 1e-3, balanceLimit = 5e-3;
constexpr double cutsLimit = 20.0;  // per 100 steps
constexpr double nearLimit = 0.67;  // share of the limit from which a measure is shown as a warning

HealthState judged(double value, double limit) {
    if (!(value <= limit)) return HealthState::Bad;  // also a value that is not a number
    return value > nearLimit * limit ? HealthState::Warning : HealthState::Good;
}

void setCourse(HealthRow& row, std::vector<double> course) {
    row.course = std::move(course);
    if (!row.course.empty()) row.value = row.course.back();
}

const StageRecord* endedRecord(const LiveRun& run, int stage) {
    for (const StageRecord& record : run.stageList())
        if (record.result.stage == stage && record.ended) return &record;
    return nullptr;
}

/// Measures from the samples up to the time shown.
void fromSamples(const LiveRun& run, std::size_t count, HealthRows& rows) {
    std::vector<double> passes, cuts, depths, residuals;
    const HealthSample* before = nullptr;
    for (std::size_t i = 0; i < count; ++i) {
        const HealthSample& sample = run.health()[i];
        passes.push_back(sample.worst.passes);
        depths.push_back(sample.worst.penetrationRatio);
        residuals.push_back(sample.worst.residual);
        const bool same = before && before->stage == sample.stage;
        const long steps = same ? sample.steps - before->steps : 0;
        const long made = same ? sample.stepCuts - before->stepCuts : sample.stepCuts;
        cuts.push_back(100.0 * static_cast<double>(made) / static_cast<double>(std::max(1L, std::max(steps, made))));
        before = &sample;
    }
    setCourse(rows[0], std::move(passes));
    setCourse(rows[1], std::move(cuts));
    setCourse(rows[2], std::move(depths));
    setCourse(rows[4], std::move(residuals));
    const StepHealth& worst = run.health()[count - 1].worst;
    rows[0].block = worst.worst;
    rows[2].block = worst.penetrated;
    rows[4].block = worst.worst;
}

}  // namespace

HealthRows healthAt(const LiveRun& run, int stage, double time) {
    HealthRows rows;
    const Numerics numerics = numericsOf(run.scene().analysis);
    const double limits[]{static_cast<double>(numerics.maxPasses), cutsLimit, penetrationLimit, balanceLimit,
                          numerics.tolerance};
    for (std::size_t i = 0; i < rows.size(); ++i) {
        rows[i].measure = static_cast<HealthMeasure>(i);
        rows[i].limit = limits[i];
    }
    const auto& samples = run.health();
    const auto after = std::upper_bound(samples.begin(), samples.end(), std::pair(stage, time),
                                        [](const auto& at, const HealthSample& sample) {
                                            return at < std::pair(sample.stage, sample.time);
                                        });
    const std::size_t count = after - samples.begin();
    const StageRecord* record = endedRecord(run, stage);
    if (count > 0) {
        fromSamples(run, count, rows);
    } else if (record) {
        const auto& health = record->result.health;
        const double steps = static_cast<double>(std::max(1L, health.steps));
        rows[0].value = static_cast<double>(health.passes) / steps;
        rows[1].value = 100.0 * static_cast<double>(health.stepCuts + health.energyCuts) / steps;
        rows[2].value = health.maxPenetrationRatio;
        rows[4].value = health.maxResidual;
    }
    std::vector<double> balance;
    for (const FrameHead& head : run.frames())
        if (std::pair(head.stage, head.time) <= std::pair(stage, time)) balance.push_back(head.energy.balanceError);
    setCourse(rows[3], std::move(balance));
    for (HealthRow& row : rows)
        if (row.value) row.state = judged(*row.value, row.limit);
    // Subdividing a step costs time but is not an error.
    if (rows[1].state == HealthState::Bad && std::isfinite(*rows[1].value)) rows[1].state = HealthState::Warning;
    // An accepted step is within the tolerance; a value close to it is normal.
    if (rows[4].value)
        rows[4].state = *rows[4].value <= rows[4].limit ? HealthState::Good
                        : std::isfinite(*rows[4].value) ? HealthState::Warning
                                                        : HealthState::Bad;
    return rows;
}

}  // namespace keyblock
