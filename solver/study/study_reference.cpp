// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/study/study_reference.h"

#include "solver/files/json/json_text.h"
#include "solver/files/json/json_tree.h"
#include "solver/files/scene/scene_reference.h"
#include "solver/study/study_fields.h"

namespace keyblock {

namespace {

JsonNode* at(JsonNode& root, std::string_view pointer) { return const_cast<JsonNode*>(nodeAt(root, pointer)); }

/// The table has the values of a list parameter as texts; in the file they may be numbers and flags, too.
void allowAnyValue(JsonNode& schema) {
    JsonNode* items = at(schema, "/$defs/parameter/properties/values/items/type");
    if (!items) return;
    JsonList types;
    for (const char* type : {"number", "string", "boolean"}) types.push_back({std::string(type)});
    items->value = std::move(types);
}

}  // namespace

std::string studySchema() {
    JsonReading schema = readJson(schemaOf(studyStructure(), "Keyblock study"));
    allowAnyValue(*schema.root);
    return jsonText(*schema.root);
}

std::string studyReferencePage() {
    return referencePageOf(
        studyStructure(),
        "<!-- SPDX-FileCopyrightText: The Keyblock contributors -->\n"
        "<!-- SPDX-License-Identifier: GPL-3.0-or-later -->\n"
        "<!-- Generated from the field table; the test StudyReference rewrites it with KEYBLOCK_REWRITE=1. -->\n\n"
        "# The study file\n\n"
        "A study runs one scene many times with different values. It is one JSON text in UTF-8, with the rules of [the "
        "scene file](scene.md). `keyblock check STUDY.json` lists all errors of the study and of its scene; [Sweeps and "
        "Monte Carlo](sweeps.md) describes how to run one.\n");
}

}  // namespace keyblock
