// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/fields/field_target.h"

#include "solver/scene/pointer.h"

#include <variant>

namespace keyblock {

namespace {

/// The map of the scene that contains the named object. Null if the field names no object, or one drawn in the section.
const Field* mapOf(const FormRow& row) {
    if (row.field->kind != FieldKind::Text || row.field->names.size() != 1) return nullptr;
    const Field* list = findField(sceneStructure(), row.field->names.front());
    return list->kind == FieldKind::Map ? list : nullptr;
}

}  // namespace

bool namesObject(const FormRow& row) { return mapOf(row) != nullptr; }

std::string nameOfTarget(const FormRow& row) {
    const auto* name = std::get_if<std::string>(&row.value);
    return name ? *name : std::string();
}

std::string targetOf(const FormRow& row) {
    const std::string name = nameOfTarget(row);
    return name.empty() || !namesObject(row) ? std::string() : under(under("", mapOf(row)->key), name);
}

}  // namespace keyblock
