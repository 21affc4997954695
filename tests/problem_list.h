// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Problems as the message of a test that fails.
#pragma once

#include "solver/scene/problem.h"

#include <string>
#include <vector>

namespace keyblock::test {

inline std::string problemList(const std::vector<Problem>& problems) {
    std::string text;
    for (const Problem& problem : problems) text += oneLine(problem) + "\n";
    return text;
}

}  // namespace keyblock::test
