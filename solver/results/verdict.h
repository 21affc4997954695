// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Whether the scene is stable according to its run: a designer's first question.
#pragma once

#include "solver/results/run_source.h"

#include <optional>
#include <string>
#include <vector>

namespace keyblock {

/// An unstable block, and the stage in which it was found unstable.
struct StageUnstable {
    int stage = 0;
    UnstableBlock block;
};

struct Verdict {
    std::optional<bool> stands;  // true if stable; none: nothing failed, but a stage is undecided or unfinished
    std::vector<StageUnstable> blocks;  // each unstable block once, with the first stage in which it was found unstable
};

/// Verdict on a run, finished or not.
/// \param records the stages begun so far, in order.
/// \param scene the scene as run.
Verdict verdictOf(const std::vector<StageRecord>& records, const Scene& scene);

/// Reason to doubt the numerical results of a stage.
struct StageWarning {
    int stage = 0;  // −1: of all stages
    std::string text;  // without a full stop
};

/// What the preset of the run must say, then warnings for all completed stages, in stage order. A stage gets a warning if
/// the unbalanced force on a block, as a fraction of the block's weight, exceeds `until.body`, another if its energy
/// balance error exceeds 1 %, another if a static stage leaves forces of more than 2 % of the acting ones unbalanced, and
/// another if blocks penetrate each other by more than 5 % of the size of the smaller one.
std::vector<StageWarning> stageWarnings(const RunSource& run);

/// The result of the stage with the largest ratio of a block's unbalanced force to the block's weight; none if no block
/// was checked.
std::optional<StageResult> worstBalanced(const std::vector<StageRecord>& records);

}  // namespace keyblock
