// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Whether what was run is stable: the first question of a designer.
#pragma once

#include "solver/results/run_source.h"

#include <optional>
#include <string>
#include <vector>

namespace keyblock {

/// An unstable block, and the stage that shows it.
struct StageUnstable {
    int stage = 0;
    UnstableBlock block;
};

struct Verdict {
    std::optional<bool> stands;  // none: nothing failed, but a stage is undecided or did not end
    std::vector<StageUnstable> blocks;  // unstable blocks, each once, by the first stage that shows it
};

/// \param scene as it is run, of whose stages `records` may be the first.
Verdict verdictOf(const std::vector<StageRecord>& records, const Scene& scene);

/// Why the numbers of a stage are doubtful.
struct StageWarning {
    int stage = 0;
    std::string text;  // a sentence without its full stop
};

/// For every stage that ended: an energy balance error above 1 %, and a block that is farther from balance than
/// `until.body` allows. In the order of the stages.
std::vector<StageWarning> stageWarnings(const RunSource& run);

/// The stage whose last equilibrium leaves most on a block, if one was judged.
std::optional<StageResult> worstBalanced(const std::vector<StageRecord>& records);

}  // namespace keyblock
