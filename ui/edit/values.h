// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Single values and entries of a scene by JSON pointer, through the field table:
// what a property panel, a script and a handle on the canvas change alike.
#pragma once

#include "solver/scene/field.h"
#include "ui/edit/edit.h"

#include <optional>
#include <string>
#include <string_view>

namespace keyblock {

/// The value that the pointer leads to: of a field, or one point or text of its list. None where there is no value.
std::optional<FieldValue> valueAt(const Scene& scene, std::string_view pointer);

/// What keeps `value` from standing in the field, as a file would be refused: kind, word, range; empty when nothing does.
std::string valueProblem(const Field& field, const FieldValue& value);

/// Puts a value where the pointer leads. A name goes to `renameAt`, so that references follow; a type of bolt that comes
/// with the program is refused, for others use it. A scene that is handed over is not copied, so that thousands of
/// objects can be set one after another.
Edit setValueAt(Scene scene, const std::string& pointer, const FieldValue& value);

/// Makes the field null (nothing, or "chosen by the program"); what cannot be null goes back to its default. An object
/// such as `/domain` goes.
Edit setNullAt(Scene scene, const std::string& pointer);

/// Gives the field the value that it has when a file does not say it.
Edit resetAt(Scene scene, const std::string& pointer);

/// Adds an entry that is ready to use to the list or map (under `name`, or a free one), or makes an Object that is null.
Edit appendAt(const Scene& scene, const std::string& pointer, std::string_view name = {});

/// Moves the entry that the pointer leads to, to the place `to` of its list; past the end is the end.
Edit moveAt(const Scene& scene, const std::string& pointer, std::size_t to);

}  // namespace keyblock
