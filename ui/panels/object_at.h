// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// An object of a scene with its field table and its parent. Panels use it to show
// fields without knowing the structs.
#pragma once

#include "solver/scene/field.h"

#include <optional>
#include <string_view>

namespace keyblock {

/// Valid as long as the scene that it belongs to.
struct ObjectAt {
    const Structure* structure = nullptr;
    const void* object = nullptr;
    const Field* holder = nullptr;  // the row of the list, map or object that holds it; null: the scene itself
    const Structure* ownerStructure = nullptr;  // of what the holder is a row of
    const void* owner = nullptr;
};

/// The object at `pointer`, if there is one. The empty pointer is the scene.
std::optional<ObjectAt> objectAt(const Scene& scene, std::string_view pointer);

/// The value of another field of the object; null if it has no such field.
FieldValue valueOf(const Structure& structure, const void* object, std::string_view key);

}  // namespace keyblock
