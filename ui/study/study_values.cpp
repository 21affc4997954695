// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/study/study_values.h"

#include "solver/files/json/json_text.h"
#include "solver/files/json/json_tree.h"
#include "solver/scene/number_text.h"
#include "solver/scene/pointer.h"
#include "solver/study/case_plan.h"
#include "solver/study/study_fields.h"
#include "ui/edit/pointer_change.h"
#include "ui/edit/typed_number.h"
#include "ui/edit/values.h"
#include "ui/look/qt_text.h"

#include <QCoreApplication>
#include <QStringList>

#include <charconv>

namespace keyblock {

namespace {

struct StudyValue {
    Q_DECLARE_TR_FUNCTIONS(StudyValue)
};

/// Whether the items of a list are JSON texts: the values of a parameter.
bool holdsJson(const StudyPlace& place) { return place.field->key == "values"; }

std::size_t indexOf(const std::string& part) {
    std::size_t index = 0;
    const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), index);
    return error == std::errc() && end == part.data() + part.size() ? index : std::string::npos;
}

/// A typed item of a list of values as JSON: a number, true or false as it is, everything else as a text.
std::string jsonItem(const std::string& text) {
    const JsonReading json = readJson(text);
    const bool isValue = json.root && (std::holds_alternative<double>(json.root->value) ||
                                       std::holds_alternative<bool>(json.root->value) ||
                                       std::holds_alternative<std::string>(json.root->value));
    return isValue ? jsonLine(*json.root) : jsonLine(JsonNode{text});
}

TypedValue typedList(const StudyPlace& place, const QString& text) {
    std::vector<std::string> items;
    for (const QString& part : text.split(place.field->isSentence ? '\n' : ',')) {
        const std::string item = part.trimmed().toStdString();
        if (!item.empty()) items.push_back(holdsJson(place) ? jsonItem(item) : item);
    }
    return {FieldValue(std::move(items)), {}};
}

TypedValue typedPair(const QString& text) {
    const QStringList parts = text.split(text.contains(';') ? ';' : ',');
    if (parts.size() != 2) return {std::nullopt, StudyValue::tr("Enter two numbers, e.g. 0.1, 0.5")};
    Point pair;
    for (int i = 0; i < 2; ++i) {
        const TypedNumber number = typedNumber(parts[i].toStdString(), "");
        if (!number.value) return {std::nullopt, QString::fromStdString(number.problem)};
        pair[i] = *number.value;
    }
    return {FieldValue(pair), {}};
}

TypedValue typedField(const StudyPlace& place, const QString& text) {
    const Field& field = *place.field;
    const QString typed = text.trimmed();
    if (field.kind == FieldKind::TextList) return typedList(place, text);
    if (field.kind == FieldKind::Text || field.kind == FieldKind::Word) return {FieldValue(typed.toStdString()), {}};
    if (field.kind == FieldKind::Vector) return typedPair(typed);
    if (typed.isEmpty() && field.nullable) return {FieldValue(), {}};
    const TypedNumber number = typedNumber(typed.toStdString(), field.unit);
    if (!number.value) return {std::nullopt, QString::fromStdString(number.problem)};
    return {FieldValue(*number.value), {}};
}

}  // namespace

std::optional<StudyPlace> placeAt(const Study& study, const std::string& pointer) {
    StudyPlace place{&studyStructure(), nullptr, &study};
    const std::vector<std::string> parts = partsOf(pointer);
    for (std::size_t i = 0; i < parts.size(); ++i) {
        place.field = findField(*place.structure, parts[i]);
        if (!place.field) return std::nullopt;
        if (i + 1 == parts.size()) break;
        if (!hasChildren(*place.field)) return std::nullopt;
        const Children& children = place.field->children;
        const std::size_t index = place.field->kind == FieldKind::Object ? 0 : indexOf(parts[++i]);
        if (index >= children.count(place.owner) || i + 1 == parts.size()) return std::nullopt;
        place.owner = children.item(place.owner, index);
        place.structure = &children.structure();
    }
    if (!place.field || !place.field->get) return std::nullopt;
    return place;
}

void setValue(Study& study, const std::string& pointer, const FieldValue& value) {
    const StudyPlace place = *placeAt(study, pointer);
    place.field->set(const_cast<void*>(place.owner), value);  // the study is the caller's own
}

QString typedText(const StudyPlace& place) {
    const FieldValue value = place.value();
    if (const auto* number = std::get_if<double>(&value)) return qt(shortest(*number));
    if (const auto* text = std::get_if<std::string>(&value)) return qt(*text);
    if (const auto* pair = std::get_if<Point>(&value)) return qt(shortest(pair->x())) + ", " + qt(shortest(pair->y()));
    QStringList items;
    if (const auto* list = std::get_if<std::vector<std::string>>(&value))
        for (const std::string& item : *list) items << qt(holdsJson(place) ? cellOf(item) : item);
    return items.join(place.field->isSentence ? "\n" : ", ");
}

TypedValue typedValue(const StudyPlace& place, const QString& text) {
    TypedValue typed = typedField(place, text);
    if (!typed.value) return typed;
    // A text or list that is empty is reported by the check, which knows whether it is needed.
    const bool isText = place.field->kind == FieldKind::Text || place.field->kind == FieldKind::TextList;
    if (!isText)
        if (const std::string problem = valueProblem(*place.field, *typed.value); !problem.empty())
            return {std::nullopt, qt(problem)};
    return typed;
}

}  // namespace keyblock
