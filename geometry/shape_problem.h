// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is wrong with the numbers that describe a shape, in words. A check of
// scenes adds the place; geometry knows no files.
#pragma once

#include <string>

namespace keyblock {

struct ShapeProblem {
    std::string field;  // as the scene file calls it
    std::string message;  // what is wrong
    std::string remedy;  // what to do
};

}  // namespace keyblock
