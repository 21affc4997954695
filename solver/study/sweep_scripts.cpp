// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Slurm sends SIGTERM to a job that is cancelled, preempted or queued again; a case then
// keeps its checkpoint, and the task resumes it when it runs again. Before the end of its
// time a task gets SIGUSR1, by which it knows that it has to queue itself again. No name
// from a study is part of a command.
#include "solver/study/sweep_scripts.h"

#include "solver/study/sweep_folder.h"

namespace keyblock {

namespace {

/// A word of the shell, in single quotes.
std::string shellWord(const std::string& text) {
    std::string quoted = "'";
    for (const char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return quoted + "'";
}

std::string commentLine(const std::string& title) {
    std::string line;
    for (const char c : title) line += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
    return line.empty() ? "" : "# " + line + "\n";
}

std::string programLine(const std::string& program) {
    return "keyblock=${KEYBLOCK:-" + (program.find_first_of("'}\"\\$`") == std::string::npos ? program : "keyblock") +
           "}\n";
}

}  // namespace

std::string slurmScript(const SweepPlan& plan, const std::string& title, const std::string& program) {
    return "#!/bin/bash\n"
           "#SBATCH --job-name=keyblock-sweep\n"
           "#SBATCH --array=1-" +
           std::to_string(plan.tasks()) +
           "\n"
           "#SBATCH --ntasks=1\n"
           "#SBATCH --cpus-per-task=1\n"
           "#SBATCH --requeue\n"
           "#SBATCH --open-mode=append\n"
           "#SBATCH --output=logs/%a.txt\n"
           "#SBATCH --signal=B:USR1@60\n" +
           commentLine(title) +
           "#\n"
           "# Submit it in this folder: sbatch submit.sbatch. Each task runs " +
           std::to_string(plan.casesPerTask) + " of " + std::to_string(plan.cases) +
           " cases. Finished cases are\n"
           "# skipped, so it may be submitted again at any time. Add what your cluster needs, e.g. partition, time and\n"
           "# memory, and the command that makes keyblock available: a module, a container, or KEYBLOCK=/path/to/keyblock.\n" +
           programLine(program) + "export OPENBLAS_CORETYPE=" + shellWord(plan.kernel) +
           "\n"
           "\"$keyblock\" sweep run \"$SLURM_SUBMIT_DIR\" &\n"
           "run=$!\n"
           "again=\n"
           "trap 'kill -TERM $run' TERM\n"
           "trap 'again=yes; kill -TERM $run' USR1\n"
           "wait $run\n"
           "code=$?\n"
           "while kill -0 $run 2>/dev/null; do wait $run; code=$?; done\n"
           "if [ -n \"$again\" ] && [ \"$code\" -eq 75 ]; then\n"
           "    scontrol requeue \"${SLURM_ARRAY_JOB_ID}_$SLURM_ARRAY_TASK_ID\"\n"
           "fi\n"
           "exit \"$code\"\n";
}

std::string parallelScript(const SweepPlan& plan, const std::string& program) {
    return "#!/bin/sh\n"
           "# Runs all cases on this machine by GNU parallel: ./run-parallel.sh [JOBS]; by default a job for each\n"
           "# processor. Finished cases are skipped, so it may be started again at any time.\n"
           "set -eu\n"
           "cd \"$(dirname \"$0\")\"\n" +
           programLine(program) + "export OPENBLAS_CORETYPE=" + shellWord(plan.kernel) +
           "\n"
           "jobs=${1:-$(nproc)}\n"
           "seq 1 " +
           std::to_string(plan.tasks()) +
           " | parallel --no-notice --jobs \"$jobs\" --line-buffer env SLURM_ARRAY_TASK_ID={} \"$keyblock\" sweep run .\n";
}

}  // namespace keyblock
