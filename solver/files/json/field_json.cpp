// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// There is one function per kind of field in each direction. Ranges are not checked
// here but in the check of the scene, which also covers scenes built in code.
#include "solver/files/json/field_json.h"

#include "solver/files/json/json_text.h"
#include "solver/scene/pointer.h"
#include "solver/scene/suggest.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace keyblock {

namespace {

/// A value being converted from JSON.
struct Place {
    const Field& field;
    const JsonNode& node;
    const std::string& pointer;
    std::vector<Problem>& problems;

    void refuse(std::string_view wanted) const {
        addError(problems, node, pointer,
                 inQuotes(field.key) + " is " + std::string(kindText(node)) + ", but must be " + std::string(wanted),
                 "Write " + std::string(wanted));
    }
};

const double* numberIn(const JsonNode& node) { return std::get_if<double>(&node.value); }

template <typename T>
std::optional<FieldValue> plain(const Place& place, std::string_view wanted) {
    if (const auto* value = std::get_if<T>(&place.node.value))
        return *value;
    place.refuse(wanted);
    return {};
}

std::optional<FieldValue> integer(const Place& place) {
    const double* number = numberIn(place.node);
    if (number && *number == std::trunc(*number) && std::abs(*number) <= std::numeric_limits<int>::max())
        return *number;
    if (number)
        addError(place.problems, place.node, place.pointer,
                 inQuotes(place.field.key) + " is " + jsonLine(place.node) + ", but must be a whole number",
                 "Write a whole number");
    else
        place.refuse("a whole number");
    return {};
}

std::optional<FieldValue> word(const Place& place) {
    const auto* text = std::get_if<std::string>(&place.node.value);
    const std::vector<std::string_view> words(place.field.words.begin(), place.field.words.end());
    if (!text) {
        place.refuse("one of " + listed(words));
        return {};
    }
    if (std::find(words.begin(), words.end(), *text) != words.end())
        return *text;
    const auto& later = place.field.laterWords;
    if (std::find(later.begin(), later.end(), *text) != later.end())
        addError(place.problems, place.node, place.pointer,
                 inQuotes(*text) + " is part of the format but not supported by this version of the program",
                 "Write one of " + listed(words));
    else
        addError(place.problems, place.node, place.pointer,
                 inQuotes(*text) + " is not a valid value of " + inQuotes(place.field.key),
                 "Write one of " + listed(words));
    return {};
}

std::optional<std::vector<double>> numbers(const JsonNode& node, std::size_t count) {
    const auto* list = std::get_if<JsonList>(&node.value);
    if (!list || list->size() != count)
        return {};
    std::vector<double> result;
    for (const JsonNode& item : *list) {
        const double* number = numberIn(item);
        if (!number)
            return {};
        result.push_back(*number);
    }
    return result;
}

std::optional<Point> point(const JsonNode& node) {
    const auto pair = numbers(node, 2);
    if (!pair)
        return {};
    return Point((*pair)[0], (*pair)[1]);
}

std::optional<FieldValue> vector(const Place& place) {
    const auto* list = std::get_if<JsonList>(&place.node.value);
    if (place.field.emptyIsZero && list && list->empty())
        return Point(0.0, 0.0);
    if (const auto value = point(place.node))
        return *value;
    place.refuse("a list of two numbers, [x, y]");
    return {};
}

std::optional<FieldValue> axis(const Place& place) {
    const auto* text = std::get_if<std::string>(&place.node.value);
    if (text && (*text == "x" || *text == "y"))
        return *text == "x" ? Point(1.0, 0.0) : Point(0.0, 1.0);
    if (const auto value = point(place.node))
        return *value;
    place.refuse("\"x\", \"y\" or a list of two numbers");
    return {};
}

// Reads rows of two numbers and reports each row that is not of this form.
std::optional<std::vector<Point>> rowsOfTwo(const Place& place, std::string_view row) {
    const auto* list = std::get_if<JsonList>(&place.node.value);
    if (!list) {
        place.refuse("a list of " + std::string(row));
        return {};
    }
    std::vector<Point> rows;
    for (std::size_t i = 0; i < list->size(); ++i) {
        if (const auto value = point((*list)[i]))
            rows.push_back(*value);
        else
            addError(place.problems, (*list)[i], under(place.pointer, i),
                     "this is " + std::string(kindText((*list)[i])) + " where two numbers are expected",
                     "Write " + std::string(row));
    }
    if (rows.size() != list->size())
        return {};
    return rows;
}

std::optional<FieldValue> points(const Place& place) {
    if (auto rows = rowsOfTwo(place, "points [x, y]"))
        return std::move(*rows);
    return {};
}

std::optional<FieldValue> pointPair(const Place& place) {
    auto rows = rowsOfTwo(place, "two points [x, y]");
    if (!rows)
        return {};
    if (rows->size() == 2)
        return std::move(*rows);
    place.refuse("a list of two points, [[x, y], [x, y]]");
    return {};
}

std::optional<FieldValue> pairs(const Place& place) {
    const auto rows = rowsOfTwo(place, "rows of two numbers");
    if (!rows)
        return {};
    Table table;
    for (const Point& row : *rows)
        table.emplace_back(row.x(), row.y());
    return table;
}

std::optional<FieldValue> triple(const Place& place) {
    if (const auto three = numbers(place.node, 3))
        return Stress{(*three)[0], (*three)[1], (*three)[2]};
    place.refuse("a list of three numbers, [sxx, syy, sxy]");
    return {};
}

std::optional<FieldValue> placeOnBolt(const Place& place) {
    if (const double* number = numberIn(place.node))
        return BoltPlace{false, *number};
    const auto* text = std::get_if<std::string>(&place.node.value);
    if (text && *text == "head")
        return BoltPlace{true, 0.0};
    place.refuse("metres from the far end, or \"head\"");
    return {};
}

std::optional<FieldValue> textList(const Place& place) {
    const auto* list = std::get_if<JsonList>(&place.node.value);
    std::vector<std::string> texts;
    if (list)
        for (const JsonNode& item : *list)
            if (const auto* text = std::get_if<std::string>(&item.value))
                texts.push_back(*text);
    if (list && texts.size() == list->size())
        return texts;
    place.refuse("a list of texts");
    return {};
}

std::optional<FieldValue> textMap(const Place& place) {
    const auto* object = std::get_if<JsonObject>(&place.node.value);
    std::map<std::string, std::string> texts;
    if (object)
        for (const JsonMember& member : *object)
            if (const auto* text = std::get_if<std::string>(&member.node.value))
                texts.emplace(member.key, *text);
    if (object && texts.size() == object->size())
        return texts;
    place.refuse("an object of texts");
    return {};
}

JsonNode jsonFromPlain(const FieldValue& value);

std::optional<FieldValue> fixed(const Place& place) {
    std::string accepted;
    for (const FieldValue& value : place.field.accepted) {
        const std::string text = jsonLine(jsonFromPlain(value));
        if (jsonLine(place.node) == text)
            return value;
        accepted += (accepted.empty() ? "" : " or ") + text;
    }
    addError(place.problems, place.node, place.pointer,
             inQuotes(place.field.key) + " can only be " + accepted + " in this version of the program",
             "Remove it. " + std::string(place.field.help));
    return {};
}

JsonNode pairOf(double a, double b) { return {JsonList{{a}, {b}}}; }

struct JsonMaker {
    JsonNode operator()(std::monostate) const { return {}; }
    JsonNode operator()(bool flag) const { return {flag}; }
    JsonNode operator()(double number) const { return {number}; }
    JsonNode operator()(const std::string& text) const { return {text}; }
    JsonNode operator()(const Point& p) const { return pairOf(p.x(), p.y()); }
    JsonNode operator()(const std::vector<Point>& list) const {
        JsonList result;
        for (const Point& p : list)
            result.push_back(pairOf(p.x(), p.y()));
        return {std::move(result)};
    }
    JsonNode operator()(const Table& table) const {
        JsonList result;
        for (const auto& [a, b] : table)
            result.push_back(pairOf(a, b));
        return {std::move(result)};
    }
    JsonNode operator()(const Stress& stress) const { return {JsonList{{stress[0]}, {stress[1]}, {stress[2]}}}; }
    JsonNode operator()(const BoltPlace& place) const {
        return place.head ? JsonNode{std::string("head")} : JsonNode{place.s};
    }
    JsonNode operator()(const std::vector<std::string>& texts) const {
        JsonList result;
        for (const std::string& text : texts)
            result.push_back({text});
        return {std::move(result)};
    }
    JsonNode operator()(const std::map<std::string, std::string>& texts) const {
        JsonObject result;
        for (const auto& [key, text] : texts)
            result.push_back({key, {text}});
        return {std::move(result)};
    }
};

JsonNode jsonFromPlain(const FieldValue& value) { return std::visit(JsonMaker{}, value); }

}  // namespace

void addError(std::vector<Problem>& problems, const JsonNode& node, std::string pointer, std::string message,
              std::string remedy) {
    addProblem(
        problems, {Severity::Error, "", node.line, std::move(pointer), std::move(message), std::move(remedy)});
}

std::optional<FieldValue> valueFromJson(const Field& field, const JsonNode& node, const std::string& pointer,
                                        std::vector<Problem>& problems) {
    const Place place{field, node, pointer, problems};
    if (field.nullable && std::holds_alternative<std::monostate>(node.value))
        return FieldValue{};
    switch (field.kind) {
        case FieldKind::Flag: return plain<bool>(place, "true or false");
        case FieldKind::Number: return plain<double>(place, "a number");
        case FieldKind::Integer: return integer(place);
        case FieldKind::Text: return plain<std::string>(place, "a text");
        case FieldKind::Word: return word(place);
        case FieldKind::Vector: return vector(place);
        case FieldKind::Axis: return axis(place);
        case FieldKind::PointPair: return pointPair(place);
        case FieldKind::Points: return points(place);
        case FieldKind::Pairs: return pairs(place);
        case FieldKind::Triple: return triple(place);
        case FieldKind::Place: return placeOnBolt(place);
        case FieldKind::TextList: return textList(place);
        case FieldKind::TextMap: return textMap(place);
        case FieldKind::Fixed: return fixed(place);
        case FieldKind::Object:
        case FieldKind::List:
        case FieldKind::Map: break;  // read member by member
    }
    return {};
}

JsonNode jsonFromValue(const Field& field, const FieldValue& value) {
    if (field.kind == FieldKind::Axis && value == FieldValue(Point(1.0, 0.0)))
        return {std::string("x")};
    if (field.kind == FieldKind::Axis && value == FieldValue(Point(0.0, 1.0)))
        return {std::string("y")};
    if (field.emptyIsNull && (value == FieldValue(std::string()) || value == FieldValue(Table())))
        return {};
    return jsonFromPlain(value);
}

}  // namespace keyblock
