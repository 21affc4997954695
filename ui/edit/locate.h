// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// From a JSON pointer to the row of the field table and the struct that contains it.
#pragma once

#include "solver/scene/field.h"

#include <optional>
#include <string>
#include <string_view>

namespace keyblock {

/// Where a pointer leads: the row `field` of `owner`, an entry of that row's list or map, or an element of its value.
struct ScenePlace {
    const Structure* structure = nullptr;  // of `owner`
    const void* owner = nullptr;  // in the given scene
    const Field* field = nullptr;  // null: the whole scene
    std::optional<std::size_t> entry{};  // of a List or Map
    std::optional<std::size_t> element{};  // of Points, a PointPair or a TextList
    const Field* misplaced = nullptr;  // the first field on the path that does not apply to its owner; null: all apply

    /// True if the pointer leads to a struct: the scene, an existing Object, or an entry.
    bool isObject() const;
    const Structure& objectStructure() const;  // \pre isObject()
    const void* object() const;  // \pre isObject()
};

/// None if the pointer leads nowhere in this scene. A null Object is found as the row of its owner.
std::optional<ScenePlace> locate(const Scene& scene, std::string_view pointer);

/// The pointer of the object that contains `pointer`, or `pointer` itself: `/bolts/3` for `/bolts/3/head`. Empty
/// for fields of the scene itself and for invalid pointers.
std::string objectPointer(const Scene& scene, std::string_view pointer);

/// The same address, writable; the caller must own the only copy of the scene.
void* changeable(const void* owner);

}  // namespace keyblock
