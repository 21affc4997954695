// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/fields/object_at.h"

#include "ui/edit/locate.h"

namespace keyblock {

std::optional<ObjectAt> objectAt(const Scene& scene, std::string_view pointer) {
    const auto place = locate(scene, pointer);
    if (!place || !place->isObject()) return std::nullopt;
    ObjectAt at{&place->objectStructure(), place->object(), place->field};
    if (!place->field) return at;
    at.ownerStructure = place->structure;
    at.owner = place->owner;
    return at;
}

FieldValue valueOf(const Structure& structure, const void* object, std::string_view key) {
    const Field* field = findField(structure, key);
    return field && field->get ? field->get(object) : FieldValue();
}

}  // namespace keyblock
