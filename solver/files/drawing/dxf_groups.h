// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A DXF file as what it is made of: pairs of lines, a code and a value. Whatever
// cannot be pairs is found here, before any library sees it.
#pragma once

#include "solver/scene/problem.h"

#include <string>
#include <string_view>
#include <vector>

namespace keyblock {

struct DxfGroup {
    int code = 0;
    std::string_view value;  // of a number, without blanks around it
    int line = 0;  // of the value, from 1
};

struct DxfGroups {
    std::vector<DxfGroup> groups;  // up to the one that ends the file, without comments
    std::vector<Problem> problems;
};

/// Cuts a text into groups, which refer to it. Not a text file, a binary DXF, a DWG, a line that is no code, or a file
/// that ends amid its entities is an error.
DxfGroups readDxfGroups(std::string_view text);

/// Whether the value of a code is a real number (coordinates, lengths, angles).
bool isRealCode(int code);

}  // namespace keyblock
