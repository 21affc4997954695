// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Names of objects: the title shown to the user, free names for new objects, and
// renaming.
#pragma once

#include "ui/edit/edit.h"

#include <string>
#include <string_view>
#include <vector>

namespace keyblock {

/// `stem` and the number after the largest one of `taken` with that stem: J13 after J12.
std::string freeName(std::string_view stem, const std::vector<std::string>& taken);

/// A free name for a new entry of the list or map at the pointer, in the style of its kind: `J13`,
/// `B2`, `stage 3`. Empty if its entries have no names.
std::string newName(const Scene& scene, std::string_view list);

/// A free name for a copy of the entry `name` of that list: `J12` gives J13, `roof` gives `roof 2`.
std::string nameOfCopy(const Scene& scene, std::string_view list, std::string_view name);

/// The title of the object at the pointer: `joint J12`, `domain`, `load 2 of stage load`, `bottom support`.
std::string titleAt(const Scene& scene, std::string_view pointer);

/// The name of the object; empty if it has none.
std::string nameAt(const Scene& scene, std::string_view pointer);

/// Renames the object and all references to it. Refused: an empty name if one is needed, a name already used.
Edit renameAt(const Scene& scene, const std::string& pointer, const std::string& name);

}  // namespace keyblock
