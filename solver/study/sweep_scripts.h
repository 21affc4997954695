// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The scripts that start a sweep: for Slurm, and for GNU parallel on one machine.
#pragma once

#include <string>

namespace keyblock {

struct SweepPlan;

/// submit.sbatch: a job array with a task for each group of cases.
std::string slurmScript(const SweepPlan& plan, const std::string& title, const std::string& program);

/// run-parallel.sh: all tasks on this machine.
std::string parallelScript(const SweepPlan& plan, const std::string& program);

}  // namespace keyblock
