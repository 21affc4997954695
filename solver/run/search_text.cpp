// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/results/result_names.h"
#include "solver/run/run.h"
#include "solver/scene/number_text.h"
#include "solver/scene/units.h"

namespace keyblock {

namespace {

constexpr long shortSearch = 10;  // number of solutions; most searches end earlier
constexpr double leastMove = 1e-5;  // [m]; a block that moves less is not named

}  // namespace

std::string searchText(const StepHealth& step, const std::vector<std::string>& names) {
    if (step.searched < shortSearch) return {};
    const std::string text = "searching, " + std::to_string(step.searched) + " solves";
    const std::string block = blockName(names, step.moving);
    if (block.empty() || step.moved < leastMove) return text;
    const bool far = step.moved >= 1.0;
    return text + ": " + block + " moves " + rounded(far ? step.moved : fromSi(step.moved, namedUnit("mm"))) + (far ? " m" : " mm");
}

}  // namespace keyblock
