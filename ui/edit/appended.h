// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Appends a drawn object to its list under a name that is not yet used.
#pragma once

#include "solver/scene/pointer.h"
#include "ui/edit/edit.h"
#include "ui/edit/names.h"

namespace keyblock {

/// Adds `item` at the end of a list. In a list of named entries, the item keeps its name if the list does not contain
/// this name yet; otherwise the item gets a new name.
/// \param pointer the JSON pointer of the list.
template <typename Item>
Edit appended(const Scene& scene, std::vector<Item> Scene::*list, const std::string& pointer, const Item& item) {
    Edit edit{scene};
    Item& made = (edit.scene.*list).emplace_back(item);
    if constexpr (requires { made.name; })
        made.name = made.name.empty() ? newName(scene, pointer) : nameOfCopy(scene, pointer, made.name);
    edit.made = under(pointer, (edit.scene.*list).size() - 1);
    return edit;
}

}  // namespace keyblock
