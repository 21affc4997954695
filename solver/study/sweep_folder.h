// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A sweep on disk: the frozen scene and study, the table of cases, scripts for job
// schedulers, and a folder for each case that has begun.
#pragma once

#include "solver/study/study.h"
#include "solver/study/study_file.h"

#include <filesystem>
#include <string>

namespace keyblock {

/// Names in the folder of a sweep.
inline constexpr const char *sweepPlanName = "plan.json", *sweepSceneName = "scene.json",
                            *sweepStudyName = "study.json", *sweepCasesName = "cases.csv", *sweepRunsName = "cases";

/// Most tasks of a job array where the study gives no number of cases for each: one less than the default of Slurm's
/// MaxArraySize.
inline constexpr long mostTasks = 1000;

/// What plan.json says.
struct SweepPlan {
    long cases = 0;
    long casesPerTask = 1;
    std::string kernel;  // of OpenBLAS
    std::string build;
    std::string sceneHash, studyHash, casesHash;  // SHA-256 of the files
    std::string hash;  // of plan.json itself

    long tasks() const { return (cases + casesPerTask - 1) / casesPerTask; }
};

/// First and last case of a task, counted from 1.
struct CaseRange {
    long first = 1, last = 1;
};
CaseRange casesOfTask(const SweepPlan& plan, long task);

/// Writes the folder of a sweep, whole or not at all. \param program path of the program, for the scripts.
/// \throws CannotWrite if the folder contains anything, or cannot be written
SweepPlan planSweep(const std::filesystem::path& folder, const StudyReading& read, const std::string& program);

/// Reads plan.json. \throws CannotRead if the folder has none, or it is damaged
SweepPlan readSweepPlan(const std::filesystem::path& folder);

/// A sweep whose frozen files have been read.
struct Sweep {
    std::filesystem::path folder;
    SweepPlan plan;
    Study study;
    std::string sceneText;
};

/// Reads a planned sweep. \throws CannotRead if a file is missing or is not the one that was planned
Sweep openSweep(const std::filesystem::path& folder);

/// Folder of a case, of at most a thousand in a folder.
std::filesystem::path caseFolder(const std::filesystem::path& sweep, long number);

/// The file that is written last, when a case has finished.
std::filesystem::path summaryPath(const std::filesystem::path& sweep, long number);

}  // namespace keyblock
