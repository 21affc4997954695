// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A study is written with the table with which it is read. Only the values of lists are
// JSON texts there, which become numbers, texts and flags again.
#include "solver/files/atomic_file.h"
#include "solver/files/json/json_text.h"
#include "solver/files/json/json_tree.h"
#include "solver/files/json/object_writer.h"
#include "solver/study/study_fields.h"
#include "solver/study/study_file.h"

#include <ostream>

namespace keyblock {

namespace {

/// Sets the fields that do not apply to their defaults, also in nested objects.
void settleStudy(const Structure& structure, void* object) {
    for (const Field& field : structure.fields) {
        if (hasChildren(field))
            for (std::size_t i = 0; i < field.children.count(object); ++i)
                settleStudy(field.children.structure(), const_cast<void*>(field.children.item(object, i)));
        else if (field.set && !applies(structure, field, object)) field.set(object, defaultOf(structure, field));
    }
}

JsonNode* changeableMember(JsonNode& node, std::string_view key) {
    return const_cast<JsonNode*>(findMember(node, key));
}

/// The values of a list parameter as JSON: a text that is not JSON stays a text.
void makeValues(JsonNode& parameter) {
    JsonNode* values = changeableMember(parameter, "values");
    auto* list = values ? std::get_if<JsonList>(&values->value) : nullptr;
    if (!list) return;
    for (JsonNode& value : *list)
        if (const auto* text = std::get_if<std::string>(&value.value))
            if (JsonReading json = readJson(*text); json.root) value = std::move(*json.root);
}

}  // namespace

std::string studyText(const Study& study) {
    Study written = study;
    for (StudyParameter& parameter : written.parameters)
        if (parameter.name == parameter.path) parameter.name.clear();
    settleStudy(studyStructure(), &written);
    JsonNode root = objectNode(studyStructure(), &written, studyStructure().defaults);
    if (JsonNode* parameters = changeableMember(root, "parameters"))
        if (auto* list = std::get_if<JsonList>(&parameters->value))
            for (JsonNode& parameter : *list) makeValues(parameter);
    return jsonText(root);
}

void writeStudyFile(const std::filesystem::path& path, const Study& study) {
    writeAtomically(path, [&](std::ostream& out) { out << studyText(study); });
}

}  // namespace keyblock
