// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/edit/locate.h"

#include "solver/scene/pointer.h"
#include "ui/edit/pointer_change.h"

#include <charconv>

namespace keyblock {
namespace {

std::optional<std::size_t> indexIn(const std::string& part, std::size_t count) {
    std::size_t index = 0;
    const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), index);
    const bool whole = error == std::errc{} && end == part.data() + part.size();
    return whole && index < count ? std::optional(index) : std::nullopt;
}

std::optional<std::size_t> entryOf(const ScenePlace& place, const std::string& part) {
    const Children& children = place.field->children;
    if (place.field->kind == FieldKind::List) return indexIn(part, children.count(place.owner));
    for (std::size_t i = 0; i < children.count(place.owner); ++i)
        if (children.name(place.owner, i) == part) return i;
    return std::nullopt;
}

std::size_t elementCount(const FieldValue& value) {
    if (const auto* points = std::get_if<std::vector<Point>>(&value)) return points->size();
    if (const auto* texts = std::get_if<std::vector<std::string>>(&value)) return texts->size();
    return 0;
}

/// Follows one part of the pointer. \return false if it does not exist.
bool step(ScenePlace& place, const std::string& part) {
    if (place.element) return false;
    if (place.isObject()) {
        const Structure& structure = place.objectStructure();
        const void* owner = place.object();
        const Field* field = findField(structure, part);
        if (!field) return false;
        place = {&structure, owner, field};
        return true;
    }
    if (hasChildren(*place.field)) {
        if (place.field->kind == FieldKind::Object) return false;  // null
        place.entry = entryOf(place, part);
        return place.entry.has_value();
    }
    if (!place.field->get) return false;
    place.element = indexIn(part, elementCount(place.field->get(place.owner)));
    return place.element.has_value();
}

}  // namespace

bool ScenePlace::isObject() const {
    if (!field) return true;
    if (field->kind == FieldKind::Object) return field->children.count(owner) > 0;
    return entry.has_value();
}

const Structure& ScenePlace::objectStructure() const { return field ? field->children.structure() : *structure; }

const void* ScenePlace::object() const { return field ? field->children.item(owner, entry.value_or(0)) : owner; }

std::optional<ScenePlace> locate(const Scene& scene, std::string_view pointer) {
    ScenePlace place{&sceneStructure(), &scene, nullptr};
    const Field* misplaced = nullptr;
    for (const std::string& part : partsOf(pointer)) {
        if (!step(place, part)) return std::nullopt;
        if (!misplaced && place.field && !applies(*place.structure, *place.field, place.owner)) misplaced = place.field;
    }
    place.misplaced = misplaced;
    return place;
}

std::string objectPointer(const Scene& scene, std::string_view pointer) {
    ScenePlace place{&sceneStructure(), &scene, nullptr};
    std::string walked, object;
    for (const std::string& part : partsOf(pointer)) {
        if (!step(place, part)) return object;
        walked = under(walked, part);
        if (place.isObject()) object = walked;
    }
    return object;
}

void* changeable(const void* owner) { return const_cast<void*>(owner); }

}  // namespace keyblock
