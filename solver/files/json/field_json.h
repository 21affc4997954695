// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Values of fields from and to JSON, by the kind of their row.
#pragma once

#include "solver/files/json/json_tree.h"
#include "solver/scene/field.h"
#include "solver/scene/problem.h"

#include <optional>
#include <string>
#include <vector>

namespace keyblock {

/// Adds an error at `node`.
void addError(std::vector<Problem>& problems, const JsonNode& node, std::string pointer, std::string message,
              std::string remedy);

/// The value of a field that is not an Object, List or Map. Says in `problems` what keeps it from being one.
std::optional<FieldValue> valueFromJson(const Field& field, const JsonNode& node, const std::string& pointer,
                                        std::vector<Problem>& problems);

/// The value as it is in a file.
JsonNode jsonFromValue(const Field& field, const FieldValue& value);

}  // namespace keyblock
