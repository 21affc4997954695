// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// An object of a scene with its field table and its parent. With this, panels show
// fields without knowing the C++ structs.
#pragma once

#include "solver/scene/field.h"

#include <optional>
#include <string_view>

namespace keyblock {

/// Pointers to an object and its parent; valid as long as the scene exists.
struct ObjectAt {
    const Structure* structure = nullptr;
    const void* object = nullptr;
    const Field* holder = nullptr;  // field of the list, map or object that contains it; null: the object is the scene
    const Structure* ownerStructure = nullptr;  // structure to which `holder` belongs
    const void* owner = nullptr;
};

/// The object at `pointer`; none if there is no such object. An empty pointer refers to the scene itself.
std::optional<ObjectAt> objectAt(const Scene& scene, std::string_view pointer);

/// The value of the field `key` of the object; null if the object has no such field.
FieldValue valueOf(const Structure& structure, const void* object, std::string_view key);

}  // namespace keyblock
