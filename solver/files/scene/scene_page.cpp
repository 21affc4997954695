// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One heading and one table per structure.
#include "solver/files/json/field_json.h"
#include "solver/files/json/json_text.h"
#include "solver/files/scene/scene_reference.h"
#include "solver/scene/field.h"
#include "solver/scene/structure_list.h"

namespace keyblock {

namespace {

std::string asCode(const std::string& text) { return "`" + text + "`"; }

std::string wordsText(const Field& field) {
    std::string text;
    for (const std::string_view word : field.words)
        text += (text.empty() ? "" : ", ") + asCode(jsonLine({std::string(word)}));
    for (const FieldValue& value : field.accepted)
        text += (text.empty() ? "only " : ", ") + asCode(jsonLine(jsonFromValue(field, value)));
    return text;
}

std::string link(const Field& field) {
    const std::string name(field.children.structure().name);
    std::string anchor = name;
    for (char& c : anchor)
        c = c == ' ' ? '-' : c;
    return "[" + name + "](#" + anchor + ")";
}

std::string valueText(const Field& field) {
    switch (field.kind) {
        case FieldKind::Flag: return "`true`, `false`";
        case FieldKind::Number: return "number";
        case FieldKind::Integer: return "whole number";
        case FieldKind::Text: return "text";
        case FieldKind::Word:
        case FieldKind::Fixed: return wordsText(field);
        case FieldKind::Vector: return "`[x, y]`";
        case FieldKind::Axis: return "`\"x\"`, `\"y\"`, `[x, y]`";
        case FieldKind::PointPair: return "`[[x, y], [x, y]]`";
        case FieldKind::Points: return "`[[x, y], …]`";
        case FieldKind::Pairs: return "`[[a, b], …]`";
        case FieldKind::Triple: return "`[xx, yy, xy]`";
        case FieldKind::Place: return "number, `\"head\"`";
        case FieldKind::TextList: return "list of texts";
        case FieldKind::TextMap: return "object of texts";
        case FieldKind::Object: return link(field);
        case FieldKind::List: return "list of " + link(field);
        case FieldKind::Map: return "by name, " + link(field);
    }
    return {};
}

std::string defaultText(const Structure& structure, const Field& field) {
    if (field.required)
        return "*required*";
    if (hasChildren(field))
        return field.nullable ? "`null`" : "";
    return asCode(jsonLine(jsonFromValue(field, defaultOf(structure, field))));
}

std::string meaningText(const Field& field) {
    std::string text(field.help);
    if (!field.only.key.empty())
        text += " Only " + condition(field) + ".";
    if (!field.source.empty())
        text += " Source of the default: " + std::string(field.source) + ".";
    return text;
}

// Escapes vertical bars, which would end the table cell.
std::string cell(const std::string& text) {
    std::string escaped;
    for (const char c : text)
        escaped += c == '|' ? std::string("\\|") : std::string(1, c);
    return " " + escaped + " |";
}

std::string tableRow(const Structure& structure, const Field& field) {
    return "|" + cell(asCode(std::string(field.key))) + cell(valueText(field)) + cell(std::string(field.unit)) +
           cell(defaultText(structure, field)) + cell(rangeText(field.range)) + cell(meaningText(field)) + "\n";
}

std::string section(const Structure& structure) {
    std::string text = "\n## " + std::string(structure.name) + "\n\n" + std::string(structure.help) + "\n\n";
    text += "| key | value | unit | default | range | meaning |\n| --- | --- | --- | --- | --- | --- |\n";
    for (const Field& field : structure.fields)
        text += tableRow(structure, field);
    return text;
}

}  // namespace

std::string referencePageOf(const Structure& root, std::string_view head) {
    std::string text(head);
    for (const Structure* structure : structuresFrom(root)) text += section(*structure);
    return text;
}

std::string sceneReferencePage() {
    return referencePageOf(
        sceneStructure(),
        "<!-- SPDX-FileCopyrightText: The Keyblock contributors -->\n"
        "<!-- SPDX-License-Identifier: GPL-3.0-or-later -->\n"
        "<!-- Generated from the field table; the test SceneReference rewrites it with KEYBLOCK_REWRITE=1. -->\n\n"
        "# The scene file\n\n"
        "A scene is one JSON text in UTF-8. Units are SI; input angles are in degrees unless another unit is given. A "
        "missing key takes its default; a key that is not listed here, or given twice, is an error. `keyblock check` "
        "lists all errors with line and remedy.\n");
}

}  // namespace keyblock
