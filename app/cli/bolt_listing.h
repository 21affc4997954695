// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Lists the values of a bolt type with unit and source. The list is made from the
// field table, so that a new field is included automatically.
#pragma once

#include "solver/scene/scene.h"

#include <string>
#include <vector>

namespace keyblock::cli {

/// One named value of a bolt type, as text, with its unit and source.
struct BoltNumber {
    std::string key;  // e.g. `plate.width` or `anchors[0].strength`
    std::string value;
    std::string unit;
    std::string source;
    bool confirmed = true;  // false: no available source gives the value
};

/// Values of a bolt type, in the order of the scene format. Fields that do not apply to the type or have no value are
/// omitted.
std::vector<BoltNumber> numbersOf(const BoltType& type);

}  // namespace keyblock::cli
