// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A bolt type number by number: value, unit and where it comes from. What is listed
// follows from the table of fields, so that a new field shows by itself.
#pragma once

#include "solver/scene/scene.h"

#include <string>
#include <vector>

namespace keyblock::cli {

/// One value of a type.
struct BoltNumber {
    std::string key;  // as in `plate.width`, `anchors[0].strength`
    std::string value;
    std::string unit;
    std::string source;
    bool confirmed = true;  // false: no available source gives it
};

/// Every value of the type that applies and is not null, in the order of the format.
std::vector<BoltNumber> numbersOf(const BoltType& type);

}  // namespace keyblock::cli
