// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Names of objects: titles shown to the user, unused names for new objects, and
// renaming.
#pragma once

#include "ui/edit/edit.h"

#include <string>
#include <string_view>
#include <vector>

namespace keyblock {

/// A name that is not in `taken`: `stem` followed by a number. The number is 1 greater than the largest one that
/// follows this stem in `taken`, e.g. `J13` if `taken` contains `J12`, or 1 if no name has this form.
std::string freeName(std::string_view stem, const std::vector<std::string>& taken);

/// An unused name for a new entry of the list or map at a JSON pointer, in the usual form for its kind: `J13`, `B2`,
/// `stage 3`. Empty if the entries have no names.
std::string newName(const Scene& scene, std::string_view list);

/// An unused name for a copy of the entry `name` of a list: `name` itself if the list does not contain it, otherwise
/// e.g. `J13` for `J12` or `roof 2` for `roof`.
std::string nameOfCopy(const Scene& scene, std::string_view list, std::string_view name);

/// Title of the object at a JSON pointer, as shown to the user: `joint J12`, `domain`, `load 2 of stage excavate`,
/// `bottom support`.
std::string titleAt(const Scene& scene, std::string_view pointer);

/// Name of the object at a JSON pointer; empty if it has none.
std::string nameAt(const Scene& scene, std::string_view pointer);

/// Renames an object and updates all references to it. Refused if the name is already used, or if it is empty and the
/// object needs a name.
Edit renameAt(const Scene& scene, const std::string& pointer, const std::string& name);

}  // namespace keyblock
