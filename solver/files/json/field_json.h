// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Conversion of field values from and to JSON, according to the field's kind.
#pragma once

#include "solver/files/json/json_tree.h"
#include "solver/scene/field.h"
#include "solver/scene/problem.h"

#include <optional>
#include <string>
#include <vector>

namespace keyblock {

/// Adds an error about the value `node`, at its line.
/// \param pointer the JSON pointer to `node`.
void addError(std::vector<Problem>& problems, const JsonNode& node, std::string pointer, std::string message,
              std::string remedy);

/// Reads the value of a field that is not an Object, List or Map. If it cannot be read, the reason is added to
/// `problems` and no value is returned.
std::optional<FieldValue> valueFromJson(const Field& field, const JsonNode& node, const std::string& pointer,
                                        std::vector<Problem>& problems);

/// JSON form of a field's value, as written in a scene file.
JsonNode jsonFromValue(const Field& field, const FieldValue& value);

}  // namespace keyblock
