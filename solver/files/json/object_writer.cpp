// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/files/json/object_writer.h"

#include "solver/files/json/field_json.h"

namespace keyblock {

namespace {

JsonNode childrenNode(const Field& field, const void* object, const void* reference) {
    const Children& children = field.children;
    const Structure& structure = children.structure();
    if (children.isNull(object)) return {};
    if (field.kind == FieldKind::Object)
        return objectNode(structure, children.item(object, 0),
                          children.isNull(reference) ? structure.defaults : children.item(reference, 0));
    JsonList list;
    JsonObject map;
    for (std::size_t i = 0; i < children.count(object); ++i) {
        JsonNode node = objectNode(structure, children.item(object, i), structure.defaults);
        if (field.kind == FieldKind::List) list.push_back(std::move(node));
        else map.push_back({std::string(children.name(object, i)), std::move(node)});
    }
    return field.kind == FieldKind::List ? JsonNode{std::move(list)} : JsonNode{std::move(map)};
}

}  // namespace

JsonNode fieldNode(const Field& field, const void* object, const void* reference) {
    if (hasChildren(field)) return childrenNode(field, object, reference);
    return jsonFromValue(field, field.get ? field.get(object) : field.accepted.front());
}

JsonNode objectNode(const Structure& structure, const void* object, const void* reference) {
    JsonObject members;
    for (const Field& field : structure.fields)
        if (field.required || !sameValue(field, object, reference))
            members.push_back({std::string(field.key), fieldNode(field, object, reference)});
    return {std::move(members)};
}

}  // namespace keyblock
