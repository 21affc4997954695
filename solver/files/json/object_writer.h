// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes objects as JSON according to the field table, the inverse of `readObject`.
#pragma once

#include "solver/files/json/json_tree.h"
#include "solver/scene/field.h"

namespace keyblock {

/// The object with all required fields and all fields whose values differ from those of `reference`, in the order of
/// the table.
/// \param object a struct of the type described by `structure`.
/// \param reference another one, for example the defaults of the structure.
JsonNode objectNode(const Structure& structure, const void* object, const void* reference);

/// The value of a field of `object`; nested objects are written as by `objectNode`.
JsonNode fieldNode(const Field& field, const void* object, const void* reference);

}  // namespace keyblock
