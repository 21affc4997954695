// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Evaluates the accelerations of a stage (records, sines and constant values) as functions
// of time, and integrates records to velocity and displacement. The check and the run
// both use these functions.
#pragma once

#include "solver/scene/scene.h"

namespace keyblock {

/// Value of a record at a time [s], interpolated linearly; zero before the first row and after the last row.
/// \pre times increase from row to row.
double recordAt(const Table& record, double time);

/// Acceleration [m/s²] at a time [s] from the start of the stage. A constant value is returned in full, although static
/// stages scale it with pseudo-time.
/// \pre the check of the scene found no error in `acceleration`.
Point accelerationAt(const Acceleration& acceleration, double time);

/// Body force per unit mass [m/s²] in addition to gravity, at a time [s] from the start of the stage. It is the body
/// acceleration minus the acceleration of the ground (theory, "Shaking"); zero if the stage has neither.
Point bodyForceAt(const Stage& stage, double time);

/// Ground velocity and displacement obtained by integrating a record from rest: the final values, and the largest
/// absolute values over all rows.
struct Baseline {
    double velocity = 0.0, peakVelocity = 0.0;  // [m/s]
    double displacement = 0.0, peakDisplacement = 0.0;  // [m]
};

/// Integrates the piecewise-linear record exactly.
/// \param factor the acceleration [m/s²] per unit of the record.
Baseline baselineOf(const Table& record, double factor);

/// Mean time between the rows of a record [s]; 0 for fewer than two rows.
double spacingOf(const Table& record);

/// Longest time step [s] that resolves all accelerations of a stage: the mean row spacing of a record, or 1/40 of the
/// period of a sine; infinite if the stage has no acceleration that varies.
double longestStepFor(const Stage& stage);

}  // namespace keyblock
