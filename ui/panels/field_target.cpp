// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/field_target.h"

#include "solver/scene/pointer.h"

#include <string_view>
#include <variant>

namespace keyblock {

namespace {

/// The map of the scene that holds the named object; empty: the field names no object.
std::string_view listOf(const FormRow& row) {
    if (row.field->kind != FieldKind::Text) return {};
    const std::string_view key = row.field->key;
    if (key == "material") return "/materials";
    if (key == "joint_material") return "/joint_materials";
    return key == "type" || key == "like" ? "/bolt_types" : "";
}

}  // namespace

bool namesObject(const FormRow& row) { return !listOf(row).empty(); }

std::string nameOfTarget(const FormRow& row) {
    const auto* name = std::get_if<std::string>(&row.value);
    return name ? *name : std::string();
}

std::string targetOf(const FormRow& row) {
    const std::string name = nameOfTarget(row);
    return name.empty() || !namesObject(row) ? std::string() : under(listOf(row), name);
}

}  // namespace keyblock
