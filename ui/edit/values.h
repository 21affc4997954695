// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads and changes single values and entries of a scene by JSON pointer, using the
// field table. Used by the property panel and by the handles on the canvas.
#pragma once

#include "solver/scene/field.h"
#include "ui/edit/edit.h"

#include <optional>
#include <string>
#include <string_view>

namespace keyblock {

/// The value at a pointer: the value of a field, or one item of a field that contains a list of points or strings. Null
/// if there is no value.
std::optional<FieldValue> valueAt(const Scene& scene, std::string_view pointer);

/// The reason why `value` is not valid for a field, by the rules of the file reader: wrong type, unknown word or out of
/// range. Empty if it is valid.
std::string valueProblem(const Field& field, const FieldValue& value);

/// Sets the value at a pointer. A new name is passed to `renameAt`, which updates references. Built-in bolt types
/// cannot be changed, because other scenes use them. To set thousands of values one after another without copying the
/// scene each time, pass `scene` with `std::move`.
Edit setValueAt(Scene scene, const std::string& pointer, const FieldValue& value);

/// Sets a field to null, which means "none" or "automatic"; a field that cannot be null gets its default. If the
/// pointer refers to an object such as `/domain`, or to an entry of a list, the object or entry is removed.
Edit setNullAt(Scene scene, const std::string& pointer);

/// Sets a field to its default: the value that applies if the file does not contain the field. Refused for required
/// fields.
Edit resetAt(Scene scene, const std::string& pointer);

/// Adds an entry with default values to the list or map at a pointer, or creates the object there if it is null.
/// \param name name of the entry; if it is empty or already used, an unused name is chosen.
Edit appendAt(const Scene& scene, const std::string& pointer, std::string_view name = {});

/// Moves the entry at a pointer to the index `to` of its list; an index beyond the end moves it to the end.
Edit moveAt(const Scene& scene, const std::string& pointer, std::size_t to);

}  // namespace keyblock
