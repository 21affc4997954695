// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Checks acceleration records. They come from external sources and are rarely
// inspected, so anything that would load the rock in an unintended way, or that
// the stage cannot resolve, is reported here.
#include "solver/scene/acceleration.h"
#include "solver/scene/check_report.h"
#include "solver/scene/number_text.h"
#include "solver/scene/pointer.h"

#include <cmath>
#include <string>

namespace keyblock {

namespace {

constexpr std::size_t mostRows = 300000;  // in all records of a scene; run files store the records with the scene
// ratio to the peak value; a smaller value at the end of the record does not count as drift
constexpr double quietEnd = 0.02;

std::string placeOfRecord(const Acceleration& acceleration, const std::string& pointer) {
    return under(pointer, acceleration.file.empty() ? "record" : "file");
}

/// Whether the rows can be integrated.
bool checkRows(const Acceleration& acceleration, const std::string& place, CheckReport& report) {
    const Table& record = acceleration.record;
    const std::string pointer = under(place, "record");
    if (!isFinite(record))
        return false;  // already reported by the field check
    if (record.size() < 2) {
        report.error(placeOfRecord(acceleration, place), "the record has " + std::to_string(record.size()) + " rows",
                     "Give at least two, each with time and value");
        return false;
    }
    bool rises = true;
    for (std::size_t i = 1; i < record.size() && rises; ++i)
        if (!(record[i].first > record[i - 1].first)) {
            rises = false;
            report.error(under(pointer, i), "the time " + shortest(record[i].first) + " does not increase",
                         "Sort the rows by time and give each time only once");
        }
    if (record.front().first < 0.0)
        report.error(under(pointer, 0), "the time is negative", "Count from the start of the stage");
    return rises;
}

/// Reports the velocity and displacement at the end of the record. If they are not zero, the ground stops abruptly
/// where the record ends: a defect of the record that no analysis can correct.
void tellBaseline(const Acceleration& acceleration, const std::string& pointer, CheckReport& report) {
    const Baseline b = baselineOf(acceleration.record, acceleration.factor);
    const bool drifts = std::abs(b.velocity) > quietEnd * b.peakVelocity ||
                        std::abs(b.displacement) > quietEnd * b.peakDisplacement;
    const std::string message = "integrated from rest, the record ends with a velocity of " + rounded(b.velocity) +
                                " m/s (largest " + rounded(b.peakVelocity) + ") and a displacement of " +
                                rounded(b.displacement) + " m (largest " + rounded(b.peakDisplacement) + ")";
    if (drifts)
        report.warning(pointer, message,
                       "Correct the baseline of the record if the ground came to rest at its initial position");
    else
        report.note(pointer, message, "No action needed");
}

void checkAgainstStage(const Acceleration& acceleration, const Stage& stage, const std::string& pointer,
                       CheckReport& report) {
    const std::string place = placeOfRecord(acceleration, pointer);
    if (acceleration.record.front().first >= stage.duration && stage.duration > 0.0)
        report.warning(place, "the record begins after the end of the stage", "Give times within the stage's seconds");
    else if (acceleration.record.back().first > stage.duration && stage.duration > 0.0)
        report.warning(place, "the stage ends at " + shortest(stage.duration) + " s, before the record does at " +
                                  shortest(acceleration.record.back().first) + " s",
                       "Give a longer duration, or accept that the rest of the record is not used");
}

void checkRecord(const Acceleration& acceleration, const Stage& stage, const std::string& pointer,
                 CheckReport& report) {
    if (!checkRows(acceleration, pointer, report))
        return;
    checkAgainstStage(acceleration, stage, pointer, report);
    if (std::isfinite(acceleration.factor))
        tellBaseline(acceleration, placeOfRecord(acceleration, pointer), report);
}

bool hasRecord(const Acceleration& acceleration) {
    return !acceleration.file.empty() || !acceleration.record.empty();
}

void checkOneIsGiven(const Acceleration& acceleration, const std::string& pointer, CheckReport& report) {
    const int given = hasRecord(acceleration) + acceleration.sine.has_value() + acceleration.value.has_value();
    if (given != 1)
        report.error(pointer, "an acceleration needs exactly one of a record ('file' or 'record'), a 'sine' and a 'value'",
                     given == 0 ? "Give one of them" : "Keep only one of them");
}

/// Static stages run in pseudo-time, which has no seconds, so records and sine waves cannot be used in them.
void checkIsConstant(const Acceleration& acceleration, const std::string& pointer, CheckReport& report) {
    const std::string remedy = "Give a constant 'value' instead, or make the stage dynamic";
    if (acceleration.sine)
        report.error(under(pointer, "sine"), "a static stage has no time in seconds, so a sine cannot act in it", remedy);
    if (hasRecord(acceleration))
        report.error(placeOfRecord(acceleration, pointer),
                     "a static stage has no time in seconds, so a record cannot act in it", remedy);
}

void checkAcceleration(const Acceleration& acceleration, const Stage& stage, const std::string& pointer,
                       CheckReport& report) {
    if (stage.kind == StageKind::Static)
        checkIsConstant(acceleration, pointer, report);
    checkOneIsGiven(acceleration, pointer, report);
    checkAxis(acceleration.axis, under(pointer, "axis"), report);
    if (acceleration.factor == 0.0)
        report.warning(under(pointer, "factor"), "the factor is 0, so there is no acceleration",
                       "Give a factor [m/s² per unit], or leave the acceleration out");
    if (acceleration.sine && acceleration.sine->amplitude == 0.0)
        report.warning(under(under(pointer, "sine"), "amplitude"), "the amplitude is 0, so there is no acceleration",
                       "Give an amplitude, or leave the acceleration out");
    if (acceleration.value == 0.0)
        report.warning(under(pointer, "value"), "the value is 0, so there is no acceleration",
                       "Give a value [m/s²], or leave the acceleration out");
    if (hasRecord(acceleration) && stage.kind == StageKind::Dynamic && !acceleration.sine && !acceleration.value)
        checkRecord(acceleration, stage, pointer, report);
}

void checkStep(const Stage& stage, const std::string& pointer, CheckReport& report) {
    const double longest = longestStepFor(stage);
    if (stage.timeStep && longest > 0.0 && *stage.timeStep > longest)
        report.warning(under(pointer, "time_step"),
                       "the time step is too long to resolve the acceleration: "
                       "the longest suitable one is " + rounded(longest) +
                           " s",
                       "Give a shorter time step, or omit it to let the program choose",
                       {RepairKind::SetAutomatic, under(pointer, "time_step")});
}

}  // namespace

void checkAccelerations(const Stage& stage, const std::string& pointer, CheckContext& context) {
    if (stage.baseAcceleration && stage.kind == StageKind::Dynamic)  // otherwise already reported by the field check
        checkAcceleration(*stage.baseAcceleration, stage, under(pointer, "base_acceleration"), context.report);
    if (stage.bodyAcceleration)
        checkAcceleration(*stage.bodyAcceleration, stage, under(pointer, "body_acceleration"), context.report);
    if (stage.kind == StageKind::Static)
        return;
    if (stage.baseAcceleration && context.scene.supports.empty())
        context.report.warning(under(pointer, "base_acceleration"), "nothing is fixed, so nothing follows the ground",
                               "Fix a block or a point with 'supports'");
    checkStep(stage, pointer, context.report);
}

void checkLengthOfRecords(CheckContext& context) {
    std::size_t rows = 0;
    for (const Stage& stage : context.scene.stages)
        for (const auto& acceleration : {&stage.baseAcceleration, &stage.bodyAcceleration})
            if (*acceleration)
                rows += (*acceleration)->record.size();
    if (rows > mostRows)
        context.report.error("/stages",
                             "the records have " + std::to_string(rows) + " rows in total, more than " +
                                 std::to_string(mostRows),
                             "Resample them, or split the scene");
}

}  // namespace keyblock
