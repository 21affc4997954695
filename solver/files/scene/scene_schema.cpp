// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Rows become properties, structures become definitions. What a schema cannot express,
// such as that a field applies only with another, is in the description.
#include "solver/files/json/field_json.h"
#include "solver/files/json/json_text.h"
#include "solver/files/scene/scene_reference.h"
#include "solver/scene/field.h"
#include "solver/scene/structure_list.h"

#include <algorithm>
#include <cmath>

namespace keyblock {

namespace {

JsonNode text(std::string_view value) { return {std::string(value)}; }

JsonNode object(std::initializer_list<JsonMember> members) { return {JsonObject(members)}; }

JsonNode typed(std::string_view type) { return object({{"type", text(type)}}); }

JsonNode listOf(JsonNode items, std::size_t least, std::optional<std::size_t> most) {
    JsonObject list{{"type", text("array")}, {"items", std::move(items)}};
    if (least > 0)
        list.push_back({"minItems", {static_cast<double>(least)}});
    if (most)
        list.push_back({"maxItems", {static_cast<double>(*most)}});
    return {std::move(list)};
}

JsonNode anyOf(std::initializer_list<JsonNode> choices) { return object({{"anyOf", {JsonList(choices)}}}); }

JsonNode ranged(const Field& field, std::string_view type) {
    JsonObject number{{"type", text(type)}};
    if (std::isfinite(field.range.least))
        number.push_back({field.range.leastExcluded ? "exclusiveMinimum" : "minimum", {field.range.least}});
    if (std::isfinite(field.range.most))
        number.push_back({field.range.mostExcluded ? "exclusiveMaximum" : "maximum", {field.range.most}});
    return {std::move(number)};
}

JsonNode enumerated(const Field& field) {
    JsonList values;
    for (const std::string_view word : field.words)
        values.push_back(text(word));
    for (const FieldValue& value : field.accepted)
        values.push_back(jsonFromValue(field, value));
    return object({{"enum", {std::move(values)}}});
}

std::string definitionName(const Structure& structure) {
    std::string name(structure.name);
    std::replace(name.begin(), name.end(), ' ', '_');
    return name;
}

JsonNode reference(const Field& field) {
    return object({{"$ref", text("#/$defs/" + definitionName(field.children.structure()))}});
}

JsonNode valueSchema(const Field& field) {
    const JsonNode pair = listOf(ranged(field, "number"), 2, 2);
    switch (field.kind) {
        case FieldKind::Flag: return typed("boolean");
        case FieldKind::Number: return ranged(field, "number");
        case FieldKind::Integer: return ranged(field, "integer");
        case FieldKind::Text: return typed("string");
        case FieldKind::Word:
        case FieldKind::Fixed: return enumerated(field);
        case FieldKind::Vector: return field.emptyIsZero ? anyOf({pair, listOf(typed("number"), 0, 0)}) : pair;
        case FieldKind::Axis: return anyOf({object({{"enum", {JsonList{text("x"), text("y")}}}}), pair});
        case FieldKind::PointPair: return listOf(pair, 2, 2);
        case FieldKind::Points: return listOf(pair, 0, {});
        case FieldKind::Pairs: return listOf(listOf(typed("number"), 2, 2), 0, {});
        case FieldKind::Triple: return listOf(typed("number"), 3, 3);
        case FieldKind::Place: return anyOf({ranged(field, "number"), object({{"const", text("head")}})});
        case FieldKind::TextList: return listOf(typed("string"), 0, {});
        case FieldKind::TextMap: return object({{"type", text("object")}, {"additionalProperties", typed("string")}});
        case FieldKind::Object: return reference(field);
        case FieldKind::List: return listOf(reference(field), 0, {});
        case FieldKind::Map: return object({{"type", text("object")}, {"additionalProperties", reference(field)}});
    }
    return {};
}

std::string description(const Field& field) {
    std::string words(field.help);
    if (!field.only.key.empty())
        words += " Only " + condition(field) + ".";
    if (!field.unit.empty())
        words += " [" + std::string(field.unit) + "]";
    return words;
}

JsonNode property(const Structure& structure, const Field& field) {
    JsonNode value = valueSchema(field);
    if (field.nullable)
        value = anyOf({std::move(value), typed("null")});
    auto& members = std::get<JsonObject>(value.value);
    members.insert(members.begin(), {"description", text(description(field))});
    if (!field.required && !hasChildren(field))
        members.push_back({"default", jsonFromValue(field, defaultOf(structure, field))});
    return value;
}

JsonObject objectSchema(const Structure& structure) {
    JsonObject properties;
    JsonList required;
    for (const Field& field : structure.fields) {
        properties.push_back({std::string(field.key), property(structure, field)});
        if (field.required)
            required.push_back(text(field.key));
    }
    JsonObject schema{{"description", text(structure.help)},
                      {"type", text("object")},
                      {"additionalProperties", {false}},
                      {"properties", {std::move(properties)}}};
    if (!required.empty())
        schema.push_back({"required", {std::move(required)}});
    return schema;
}

}  // namespace

std::string schemaOf(const Structure& root, std::string_view title) {
    JsonObject schema{{"$schema", text("https://json-schema.org/draft/2020-12/schema")}, {"title", text(title)}};
    for (JsonMember& member : objectSchema(root)) schema.push_back(std::move(member));
    JsonObject definitions;
    for (const Structure* structure : structuresFrom(root))
        if (structure != &root) definitions.push_back({definitionName(*structure), {objectSchema(*structure)}});
    schema.push_back({"$defs", {std::move(definitions)}});
    return jsonText({std::move(schema)});
}

std::string sceneSchema() { return schemaOf(sceneStructure(), "Keyblock scene"); }

}  // namespace keyblock
