// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/edit/values.h"

#include "solver/scene/check_report.h"
#include "solver/scene/lookup.h"
#include "solver/scene/pointer.h"
#include "solver/scene/suggest.h"
#include "ui/edit/locate.h"
#include "ui/edit/names.h"
#include "ui/edit/remove.h"
#include "ui/edit/settle.h"
#include "ui/edit/defaults.h"

#include <algorithm>
#include <cmath>

namespace keyblock {
namespace {

Edit refused(Scene scene, std::string why) { return {std::move(scene), std::move(why)}; }

Edit lost(Scene scene, const std::string& pointer) {
    return refused(std::move(scene),
                   "There is nothing at " + (pointer.empty() ? "the scene itself" : pointer) + " to change.");
}

/// True for a built-in bolt type or a part of one; built-in types are shared by all scenes.
bool isBuiltIn(const Scene& scene, const std::string& pointer) {
    const std::vector<std::string> parts = partsOf(pointer);
    if (parts.size() < 2 || parts[0] != "bolt_types") return false;
    const BoltType* type = findBoltType(scene, parts[1]);
    return type && type->builtIn;
}

Edit refusedBuiltIn(Scene scene, const std::string& pointer) {
    return refused(std::move(scene), "The bolt type " + inQuotes(partsOf(pointer)[1]) +
                                         " is built in. Copy it to change it.");
}

/// True if the value has the type required by the field's kind.
bool hasKind(const Field& field, const FieldValue& value) {
    switch (field.kind) {
        case FieldKind::Flag: return std::holds_alternative<bool>(value);
        case FieldKind::Number:
        case FieldKind::Integer: return std::holds_alternative<double>(value);
        case FieldKind::Text:
        case FieldKind::Word: return std::holds_alternative<std::string>(value);
        case FieldKind::Vector:
        case FieldKind::Axis: return std::holds_alternative<Point>(value);
        case FieldKind::PointPair:
        case FieldKind::Points: return std::holds_alternative<std::vector<Point>>(value);
        case FieldKind::Pairs: return std::holds_alternative<Table>(value);
        case FieldKind::Triple: return std::holds_alternative<Stress>(value);
        case FieldKind::Place: return std::holds_alternative<BoltPlace>(value);
        case FieldKind::TextList: return std::holds_alternative<std::vector<std::string>>(value);
        case FieldKind::TextMap: return std::holds_alternative<std::map<std::string, std::string>>(value);
        default: return false;
    }
}

std::string shapeProblem(const Field& field, const FieldValue& value) {
    if (const auto* text = std::get_if<std::string>(&value); text && field.kind == FieldKind::Word) {
        const std::vector<std::string_view> words(field.words.begin(), field.words.end());
        if (std::find(words.begin(), words.end(), *text) == words.end())
            return inQuotes(*text) + " is not one of " + listed(words) + ".";
    }
    if (const auto* text = std::get_if<std::string>(&value); text && text->empty() && field.required)
        return "Enter a text.";
    if (const auto* number = std::get_if<double>(&value); number && field.kind == FieldKind::Integer)
        if (*number != std::floor(*number) || std::abs(*number) > 2147483647.0) return "Give a whole number.";
    if (const auto* points = std::get_if<std::vector<Point>>(&value); points && field.kind == FieldKind::PointPair)
        if (points->size() != 2) return "Give two points.";
    return {};
}

/// False if there is no bolt type of that name, or if types would be derived from each other in a circle.
bool staysLike(Scene scene, const std::string& pointer, const FieldValue& value) {
    const auto* name = std::get_if<std::string>(&value);
    if (!name || name->empty()) return true;
    const ScenePlace place = *locate(scene, pointer);
    place.field->set(changeable(place.owner), value);
    settle(scene);
    return valueAt(scene, pointer) == value;
}

FieldValue withElement(FieldValue list, std::size_t index, const FieldValue& element, std::string& problem) {
    if (auto* points = std::get_if<std::vector<Point>>(&list); points && std::holds_alternative<Point>(element))
        (*points)[index] = std::get<Point>(element);
    else if (auto* texts = std::get_if<std::vector<std::string>>(&list);
             texts && std::holds_alternative<std::string>(element))
        (*texts)[index] = std::get<std::string>(element);
    else
        problem = "The value has the wrong type.";
    return list;
}

}  // namespace

std::optional<FieldValue> valueAt(const Scene& scene, std::string_view pointer) {
    const auto place = locate(scene, pointer);
    if (!place || !place->field || !place->field->get) return std::nullopt;
    FieldValue value = place->field->get(place->owner);
    if (!place->element) return value;
    if (const auto* points = std::get_if<std::vector<Point>>(&value)) return (*points)[*place->element];
    return std::get<std::vector<std::string>>(value)[*place->element];
}

std::string valueProblem(const Field& field, const FieldValue& value) {
    if (std::holds_alternative<std::monostate>(value))
        return field.nullable ? std::string() : "Enter a value.";
    if (!hasKind(field, value)) return "The value has the wrong type.";
    if (!isFinite(value)) return "Give a finite number.";
    if (std::string problem = shapeProblem(field, value); !problem.empty()) return problem;
    CheckReport report;
    checkValue(field, value, "", report);
    return report.problems.empty() ? std::string() : report.problems.front().remedy + ".";
}

Edit setValueAt(Scene scene, const std::string& pointer, const FieldValue& value) {
    const auto found = locate(scene, pointer);
    if (!found || !found->field || !found->field->get) return lost(std::move(scene), pointer);
    if (isBuiltIn(scene, pointer)) return refusedBuiltIn(std::move(scene), pointer);
    const std::string holder = parentOf(pointer);
    if (isName(*found->field) && std::holds_alternative<std::string>(value) && locate(scene, holder)->entry)
        return renameAt(scene, holder, std::get<std::string>(value));
    if (valueAt(scene, pointer) == value) return {std::move(scene)};
    if (found->misplaced && value != defaultOf(*found->structure, *found->field))
        return refused(std::move(scene), misplaced(*found->misplaced) + ".");
    if (found->field->key == "like" && !staysLike(scene, pointer, value))
        return refused(std::move(scene), "There is no such bolt type, or it is itself derived from this one.");
    Edit edit{std::move(scene)};
    const ScenePlace place = *locate(edit.scene, pointer);
    FieldValue whole = value;
    if (place.element) whole = withElement(place.field->get(place.owner), *place.element, value, edit.refusal);
    if (edit.done()) edit.refusal = valueProblem(*place.field, whole);
    if (!edit.done()) return edit;
    place.field->set(changeable(place.owner), whole);
    settle(edit.scene);
    return edit;
}

Edit setNullAt(Scene scene, const std::string& pointer) {
    const auto found = locate(scene, pointer);
    if (!found || !found->field) return lost(std::move(scene), pointer);
    if (found->entry || found->element) return removeAt(scene, pointer);
    if (isBuiltIn(scene, pointer)) return refusedBuiltIn(std::move(scene), pointer);
    Edit edit{std::move(scene)};
    const ScenePlace place = *locate(edit.scene, pointer);
    if (hasChildren(*place.field)) {
        place.field->children.setNull(changeable(place.owner));
        if (place.field->nullable) edit.pointers.removed(pointer);
    } else if (place.field->nullable) {
        place.field->set(changeable(place.owner), {});
    } else {
        return resetAt(std::move(edit.scene), pointer);
    }
    settle(edit.scene);
    return edit;
}

Edit resetAt(Scene scene, const std::string& pointer) {
    const auto found = locate(scene, pointer);
    if (!found || !found->field || found->element) return lost(std::move(scene), pointer);
    if (hasChildren(*found->field)) return setNullAt(std::move(scene), pointer);
    if (!found->field->get) return lost(std::move(scene), pointer);
    if (found->field->required)
        return refused(std::move(scene), "This field has no default; every scene must give it.");
    return setValueAt(std::move(scene), pointer, defaultOf(*found->structure, *found->field));
}

Edit appendAt(const Scene& scene, const std::string& pointer, std::string_view name) {
    const auto found = locate(scene, pointer);
    if (!found || !found->field || !hasChildren(*found->field) || found->entry) return lost(scene, pointer);
    if (isBuiltIn(scene, pointer)) return refusedBuiltIn(scene, pointer);
    Edit edit{scene};
    const ScenePlace place = *locate(edit.scene, pointer);
    const Children& children = place.field->children;
    if (place.field->kind == FieldKind::Object && children.count(place.owner) > 0) return edit;
    const bool isMap = place.field->kind == FieldKind::Map;
    std::string used(name.empty() ? newName(scene, pointer) : nameOfCopy(scene, pointer, name));
    if (isMap && used.empty()) used = "new";
    void* made = children.append(changeable(place.owner), used);
    const Structure& structure = children.structure();
    makeDefaults(edit.scene, structure, made);
    if (const Field* field = findField(structure, "name"); field && !isMap && !used.empty()) field->set(made, used);
    edit.made = place.field->kind == FieldKind::Object ? pointer
                : isMap                                ? under(pointer, used)
                                                       : under(pointer, children.count(place.owner) - 1);
    settle(edit.scene);
    return edit;
}

Edit moveAt(const Scene& scene, const std::string& pointer, std::size_t to) {
    Edit edit{scene};
    const auto place = locate(edit.scene, pointer);
    if (!place || !place->entry) return lost(scene, pointer);
    if (isBuiltIn(scene, parentOf(pointer))) return refusedBuiltIn(scene, pointer);
    const Children& children = place->field->children;
    const std::size_t last = std::min(to, children.count(place->owner) - 1);
    if (last == *place->entry) return edit;
    children.move(changeable(place->owner), *place->entry, last);
    if (place->field->kind == FieldKind::List) {
        edit.pointers.moved(parentOf(pointer), *place->entry, last);
        edit.made = under(parentOf(pointer), last);
    }
    return edit;
}

}  // namespace keyblock
