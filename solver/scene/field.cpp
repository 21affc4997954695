// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Operations on a row of the field table that do not depend on the struct
// behind it.
#include "solver/scene/field.h"

#include "solver/scene/number_text.h"
#include "solver/scene/structure_list.h"
#include "solver/scene/suggest.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <type_traits>

namespace keyblock {

namespace {

bool allFinite(double number) { return std::isfinite(number); }
bool allFinite(const Point& point) { return point.allFinite(); }
bool allFinite(const std::pair<double, double>& row) { return allFinite(row.first) && allFinite(row.second); }
bool allFinite(const BoltPlace& place) { return place.head || allFinite(place.s); }

template <typename Items>
bool eachFinite(const Items& items) {
    return std::all_of(items.begin(), items.end(), [](const auto& item) { return allFinite(item); });
}

bool allFinite(const std::vector<Point>& points) { return eachFinite(points); }
bool allFinite(const Table& table) { return eachFinite(table); }
bool allFinite(const Stress& stress) { return eachFinite(stress); }

template <typename Other>
bool allFinite(const Other&) {
    return true;  // flags and texts
}

bool sameObject(const Structure& structure, const void* a, const void* b) {
    return std::all_of(structure.fields.begin(), structure.fields.end(),
                       [&](const Field& field) { return sameValue(field, a, b); });
}

bool sameChildren(const Children& children, const void* a, const void* b) {
    if (children.isNull(a) != children.isNull(b) || children.count(a) != children.count(b))
        return false;
    for (std::size_t i = 0; i < children.count(a); ++i)
        if (children.name(a, i) != children.name(b, i) ||
            !sameObject(children.structure(), children.item(a, i), children.item(b, i)))
            return false;
    return true;
}

bool isOneOf(const FieldValue& value, const std::vector<std::string_view>& words) {
    const auto* text = std::get_if<std::string>(&value);
    return text && std::find(words.begin(), words.end(), *text) != words.end();
}

void collect(const Structure& structure, std::vector<const Structure*>& all) {
    if (std::find(all.begin(), all.end(), &structure) != all.end())
        return;
    all.push_back(&structure);
    for (const Field& field : structure.fields)
        if (hasChildren(field))
            collect(field.children.structure(), all);
}

}  // namespace

std::vector<const Structure*> structuresFrom(const Structure& root) {
    std::vector<const Structure*> all;
    collect(root, all);
    return all;
}

std::vector<const Structure*> allStructures() { return structuresFrom(sceneStructure()); }

const Field* findField(const Structure& structure, std::string_view key) {
    const auto found = std::find_if(structure.fields.begin(), structure.fields.end(),
                                    [&](const Field& field) { return field.key == key; });
    return found == structure.fields.end() ? nullptr : &*found;
}

bool hasChildren(const Field& field) {
    return field.kind == FieldKind::Object || field.kind == FieldKind::List || field.kind == FieldKind::Map;
}

bool isName(const Field& field) { return field.key == "name"; }

bool hasNames(const Field& field) {
    if (field.kind != FieldKind::List)
        return field.kind == FieldKind::Map;
    const std::vector<Field>& fields = field.children.structure().fields;
    return std::any_of(fields.begin(), fields.end(), isName);
}

std::string labelText(const Field& field) {
    if (!field.label.empty())
        return std::string(field.label);
    std::string text(field.key);
    std::replace(text.begin(), text.end(), '_', ' ');
    if (!text.empty() && text.front() >= 'a' && text.front() <= 'z')
        text.front() = static_cast<char>(text.front() - 'a' + 'A');
    return text;
}

std::string_view wordLabel(const Field& field, std::string_view word) {
    const auto found = std::find(field.words.begin(), field.words.end(), word);
    const std::size_t index = found - field.words.begin();
    return index < field.wordLabels.size() ? field.wordLabels[index] : word;
}

FieldValue automaticOf(const Field& field, const Scene& scene, const SceneCut* cut, const void* object) {
    return field.automatic ? field.automatic(scene, cut, object) : FieldValue{};
}

std::string_view unitIn(const Field& field, const void* object, const void* owner) {
    constexpr std::string_view between = ", or ";
    const std::size_t first = field.unit.find(between);
    if (first == std::string_view::npos)
        return field.unit;
    const bool second = field.takesSecond && field.takesSecond(object, owner);
    return second ? field.unit.substr(first + between.size()) : field.unit.substr(0, first);
}

std::string_view unitIn(const Field& field, const PairColumn& column, const void* object, const void* owner) {
    return field.takesSecond && field.takesSecond(object, owner) ? column.second : column.unit;
}

FieldValue defaultOf(const Structure& structure, const Field& field) {
    if (field.kind == FieldKind::Fixed)
        return field.accepted.front();
    return field.get ? field.get(structure.defaults) : FieldValue{};
}

bool sameValue(const Field& field, const void* a, const void* b) {
    if (hasChildren(field))
        return sameChildren(field.children, a, b);
    return !field.get || field.get(a) == field.get(b);
}

bool applies(const Structure& structure, const Field& field, const void* object) {
    if (field.only.key.empty())
        return true;
    const FieldValue value = findField(structure, field.only.key)->get(object);
    if (field.only.words.empty())
        return !std::holds_alternative<std::monostate>(value);
    return isOneOf(value, field.only.words);
}

std::string condition(const Field& field) {
    assert(!field.only.key.empty());
    std::string words;
    for (const std::string_view word : field.only.words)
        words += (words.empty() ? "" : " or ") + inQuotes(word);
    return "where " + inQuotes(field.only.key) + (words.empty() ? " is given" : " is " + words);
}

std::string misplaced(const Field& field) { return inQuotes(field.key) + " is allowed only " + condition(field); }

bool isFinite(const FieldValue& value) {
    return std::visit([](const auto& held) { return allFinite(held); }, value);
}

bool contains(const Range& range, double number) {
    const bool enough = range.leastExcluded ? number > range.least : number >= range.least;
    const bool notTooMuch = range.mostExcluded ? number < range.most : number <= range.most;
    return enough && notTooMuch;
}

std::string rangeText(const Range& range) {
    const bool below = std::isfinite(range.least);
    const bool above = std::isfinite(range.most);
    const std::string least = (range.leastExcluded ? "> " : "≥ ") + shortest(range.least);
    const std::string most = (range.mostExcluded ? "< " : "≤ ") + shortest(range.most);
    if (below && above)
        return least + ", " + most;
    return below ? least : above ? most : "";
}

}  // namespace keyblock
