// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Records, sines and constant values of acceleration as functions of time, and what a record
// leaves behind when it is integrated: the one reading of them for the check and
// for the run.
#pragma once

#include "solver/scene/scene.h"

namespace keyblock {

/// Straight lines between the rows, nothing before the first and after the last. \pre times rise.
double recordAt(const Table& record, double time);

/// The acceleration at `time` of its stage [m/s²]; of a static stage a constant one, which acts in full at the stage's
/// end. \pre it was checked.
Point accelerationAt(const Acceleration& acceleration, double time);

/// What acts on every mass in addition to gravity at `time` of a stage: the body acceleration less that of the ground
/// (theory, "Shaking") [m/s²]; zero where the stage has neither.
Point bodyForceAt(const Stage& stage, double time);

/// Velocity and displacement of a ground that moved by a record, from rest, at its last row, and the largest on the
/// way at a row.
struct Baseline {
    double velocity = 0.0, peakVelocity = 0.0;  // [m/s]
    double displacement = 0.0, peakDisplacement = 0.0;  // [m]
};

/// Integrates the straight lines exactly. \param factor [m/s²] per unit
Baseline baselineOf(const Table& record, double factor);

/// Mean time between the rows [s]; 0 for less than two.
double spacingOf(const Table& record);

/// Longest step that still follows the accelerations of a stage [s]: the spacing of a record, a fortieth of a sine's
/// period; infinite where the stage has neither.
double longestStepFor(const Stage& stage);

}  // namespace keyblock
