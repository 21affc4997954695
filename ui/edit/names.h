// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Names: what a thing is called for people, one that is free for a new thing, and
// another for an old one.
#pragma once

#include "ui/edit/edit.h"

#include <string>
#include <string_view>
#include <vector>

namespace keyblock {

/// `stem` and the next number that no name of `taken` with that stem has reached: J13 after J12.
std::string freeName(std::string_view stem, const std::vector<std::string>& taken);

/// A free name for a new entry of the list or map that the pointer leads to, in the way such things are called: `J13`,
/// `B2`, `stage 3`. Empty where its entries have no names.
std::string newName(const Scene& scene, std::string_view list);

/// A free name for a copy of something called `name` in that list: `J12` gives J13, `roof` gives `roof 2`.
std::string nameOfCopy(const Scene& scene, std::string_view list, std::string_view name);

/// What the pointer leads to, for people: `joint J12`, `domain`, `load 2 of stage load`, `bottom support`.
std::string titleAt(const Scene& scene, std::string_view pointer);

/// The name of the object; empty when it has none.
std::string nameAt(const Scene& scene, std::string_view pointer);

/// Gives the object another name, everywhere it is named. Refused: an empty name where one is needed, one that is taken.
Edit renameAt(const Scene& scene, const std::string& pointer, const std::string& name);

}  // namespace keyblock
