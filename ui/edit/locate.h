// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Finds the row of the field table, and the struct that contains the field, for a JSON
// pointer.
#pragma once

#include "solver/scene/field.h"

#include <optional>
#include <string>
#include <string_view>

namespace keyblock {

/// What a pointer refers to: the field `field` of the struct `owner`, an entry of the list or map in this field, or an
/// element of its value.
struct ScenePlace {
    const Structure* structure = nullptr;  // describes `owner`
    const void* owner = nullptr;  // the struct, within the given scene
    const Field* field = nullptr;  // null: the pointer refers to the whole scene
    std::optional<std::size_t> entry{};  // index of the entry, for a List or Map
    std::optional<std::size_t> element{};  // index of the element, for Points, a PointPair or a TextList
    const Field* misplaced = nullptr;  // first field on the path that does not apply to its owner; null: all apply

    /// True if the pointer refers to a struct: the scene, an Object that is not null, or an entry of a List or Map.
    bool isObject() const;
    const Structure& objectStructure() const;  // \pre isObject()
    const void* object() const;  // \pre isObject()
};

/// Finds what a pointer refers to; null if it refers to nothing in this scene. For an Object that is null, the result
/// refers to the field that contains the Object.
std::optional<ScenePlace> locate(const Scene& scene, std::string_view pointer);

/// Pointer to the object that contains `pointer`, e.g. `/bolts/3` for `/bolts/3/head`; `pointer` itself if it refers to
/// an object. Empty for fields of the scene itself and for invalid pointers.
std::string objectPointer(const Scene& scene, std::string_view pointer);

/// Removes const from the address. \pre the caller owns the scene, and nothing else shares it.
void* changeable(const void* owner);

}  // namespace keyblock
