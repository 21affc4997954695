// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The data files of resources/presets, which the build puts into the program.
#pragma once

#include "solver/scene/field.h"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace keyblock {

struct PresetData {
    std::string_view help, warning;
    std::vector<std::pair<std::string_view, FieldValue>> settings;  // by key of `analysis`
};

/// One row for each preset, in the order of the enumeration.
const std::vector<PresetData>& presetData();

}  // namespace keyblock
