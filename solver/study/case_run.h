// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Runs one case of a sweep to its summary. A case that is interrupted leaves its run
// store with a checkpoint, from which it is resumed.
#pragma once

#include "solver/run/run.h"
#include "solver/study/case_result.h"
#include "solver/study/sweep_folder.h"

namespace keyblock {

enum class CaseEnd { Done, Interrupted, Busy };  // busy: another process runs the case, or has just finished it

/// A sweep with what all its cases share.
struct SweepRun {
    const Sweep& sweep;
    std::vector<std::string> quantities;  // of the results: those of the study, else of its scene
    std::vector<std::string> recorded;  // with those of the scene and of the failure criterion
    int threads = 1;
};

SweepRun sweepRunOf(const Sweep& sweep, int threads);

/// The scene of a case, as it is run.
struct CaseScene {
    SceneReading read;  // without a scene if the values of the case are not valid
    std::vector<BoltFault> faults;
    std::vector<double> faultMeasures;  // one for each fault of the study; empty if the scene is not valid
};

/// The scene of a case, counted from 1. \throws CannotRead if the table of cases cannot be read or lacks the case
CaseScene caseScene(const SweepRun& run, long number);

/// Runs a case, counted from 1, unless `control.stop` is set meanwhile. A case that cannot be run, or fails
/// numerically, is done too: its summary gives the reason.
/// \param result receives the result of a case that is done.
/// \throws CannotWrite
CaseEnd runCase(const SweepRun& run, long number, Control& control, SweepCaseResult& result);

}  // namespace keyblock
