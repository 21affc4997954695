// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// An object of a scene with its table and what holds it: what the panels walk to
// show fields without knowing the structs.
#pragma once

#include "solver/scene/field.h"

#include <optional>
#include <string_view>

namespace keyblock {

/// Lives as long as the scene that it was asked of.
struct ObjectAt {
    const Structure* structure = nullptr;
    const void* object = nullptr;
    const Field* holder = nullptr;  // the row of the list, map or object that holds it; null: the scene itself
    const Structure* ownerStructure = nullptr;  // of what the holder is a row of
    const void* owner = nullptr;
};

/// What stands at `pointer`; none where no object of the scene has it. The empty pointer is the scene.
std::optional<ObjectAt> objectAt(const Scene& scene, std::string_view pointer);

/// The value of another field of the object; nothing where it has no such field.
FieldValue valueOf(const Structure& structure, const void* object, std::string_view key);

}  // namespace keyblock
