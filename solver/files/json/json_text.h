// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes a JSON tree as text that is easy to read and compare: lists and objects that
// fit on a line are written on one, all others are indented over several lines.
#pragma once

#include "solver/files/json/json_tree.h"

#include <string>

namespace keyblock {

/// The tree as JSON text that ends with a line feed. Numbers have as few digits as are needed to read them back
/// exactly.
std::string jsonText(const JsonNode& node);

/// The tree as JSON text on one line, without a line feed. Numbers are written as in `jsonText`.
std::string jsonLine(const JsonNode& node);

}  // namespace keyblock
