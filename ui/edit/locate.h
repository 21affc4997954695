// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// From a JSON pointer to the row of the field table and the struct that holds it.
#pragma once

#include "solver/scene/field.h"

#include <optional>
#include <string>
#include <string_view>

namespace keyblock {

/// Where a pointer leads: the row `field` of `owner`, an entry of that row's list or map, or an element of its value.
struct ScenePlace {
    const Structure* structure = nullptr;  // of `owner`
    const void* owner = nullptr;  // in the scene that was asked
    const Field* field = nullptr;  // null: the whole scene
    std::optional<std::size_t> entry{};  // of a List or Map
    std::optional<std::size_t> element{};  // of Points, a PointPair or a TextList
    const Field* misplaced = nullptr;  // the first on the way here that does not belong to its owner; null: all do

    /// True when the pointer leads to a struct: the scene, an Object that is there, or an entry.
    bool isObject() const;
    const Structure& objectStructure() const;  // \pre isObject()
    const void* object() const;  // \pre isObject()
};

/// None where the pointer leads to nothing in this scene. A null Object is found as the row of its owner.
std::optional<ScenePlace> locate(const Scene& scene, std::string_view pointer);

/// The pointer of the object that holds what `pointer` leads to, or of it itself: `/bolts/3` for `/bolts/3/head`. Empty
/// for what the scene itself holds, and for what is not there.
std::string objectPointer(const Scene& scene, std::string_view pointer);

/// The same place in a scene of which the caller has the only copy.
void* changeable(const void* owner);

}  // namespace keyblock
