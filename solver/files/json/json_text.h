// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A JSON tree as a text that people read and compare: what fits on a line is put
// on one, everything else is indented.
#pragma once

#include "solver/files/json/json_tree.h"

#include <string>

namespace keyblock {

/// The text of a tree, with a line end at its end. Numbers are as short as they can be read back exactly.
std::string jsonText(const JsonNode& node);

/// The same on one line, without a line end.
std::string jsonLine(const JsonNode& node);

}  // namespace keyblock
