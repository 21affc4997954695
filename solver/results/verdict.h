// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Whether what was run stands: the question that a designer asks of a run.
#pragma once

#include "solver/results/run_source.h"

#include <optional>
#include <vector>

namespace keyblock {

/// A block that does not stand, and the stage that says so.
struct StageUnstable {
    int stage = 0;
    UnstableBlock block;
};

struct Verdict {
    std::optional<bool> stands;  // none: nothing failed, but a stage is undecided or did not end
    std::vector<StageUnstable> blocks;  // that do not stand, a block once, by the first stage that says so
};

/// \param stages of the scene, of which `records` may be the first.
Verdict verdictOf(const std::vector<StageRecord>& records, std::size_t stages);

/// The stage whose last equilibrium leaves most on a block, if one was judged.
std::optional<StageResult> worstBalanced(const std::vector<StageRecord>& records);

}  // namespace keyblock
