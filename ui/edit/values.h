// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads and changes single values and entries of a scene by JSON pointer, through
// the field table. Used by the property panel and by handles on the canvas.
#pragma once

#include "solver/scene/field.h"
#include "ui/edit/edit.h"

#include <optional>
#include <string>
#include <string_view>

namespace keyblock {

/// The value at the pointer: of a field, or one point or text of its list. None if there is no value.
std::optional<FieldValue> valueAt(const Scene& scene, std::string_view pointer);

/// Why `value` is not valid for the field, by the rules of the file reader: type, word, range; empty if it is valid.
std::string valueProblem(const Field& field, const FieldValue& value);

/// Sets the value at the pointer. A name is passed to `renameAt`, which updates references; built-in bolt types are
/// refused because other scenes use them. A moved-in scene is not copied, so that thousands of
/// objects can be set one after another.
Edit setValueAt(Scene scene, const std::string& pointer, const FieldValue& value);

/// Makes the field null (nothing, or "automatic"); a field that cannot be null gets its default. An object
/// such as `/domain` is removed.
Edit setNullAt(Scene scene, const std::string& pointer);

/// Sets the field to its default, the value if it is missing in a file.
Edit resetAt(Scene scene, const std::string& pointer);

/// Adds a usable entry to the list or map (with `name`, or a free name), or creates an Object that is null.
Edit appendAt(const Scene& scene, const std::string& pointer, std::string_view name = {});

/// Moves the entry at the pointer to index `to` of its list, at most to its end.
Edit moveAt(const Scene& scene, const std::string& pointer, std::size_t to);

}  // namespace keyblock
