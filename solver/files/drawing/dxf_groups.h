// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A DXF file as a sequence of groups: pairs of lines with a code and a value. Input
// that does not consist of such pairs is rejected here, before any library reads it.
#pragma once

#include "solver/scene/problem.h"

#include <string>
#include <string_view>
#include <vector>

namespace keyblock {

struct DxfGroup {
    int code = 0;
    std::string_view value;  // for numbers, without surrounding blanks
    int line = 0;  // line of the value, from 1
};

struct DxfGroups {
    std::vector<DxfGroup> groups;  // up to the group that ends the file, without comments
    std::vector<Problem> problems;
};

/// Splits the text of a DXF file into groups, which refer to `text`. The result has an error if the file is binary
/// (including binary DXF and DWG), if a line that must be a group code is not one, or if the file ends in the middle of
/// its entities.
DxfGroups readDxfGroups(std::string_view text);

/// Whether groups with this code have a real number as their value (coordinates, lengths, angles).
bool isRealCode(int code);

}  // namespace keyblock
