// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The checks that need nothing but the field table.
#include "solver/scene/check_report.h"
#include "solver/scene/number_text.h"
#include "solver/scene/pointer.h"
#include "solver/scene/suggest.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace keyblock {

namespace {

// No quantity of a rock mass comes near these, in any unit of the format; the products of some such numbers leave the
// range of a double, and results would be infinite or not a number.
constexpr double largest = 1e20;
constexpr double smallest = 1e-40;  // of a quantity that must be positive

double magnitudeOf(double number) { return std::abs(number); }
double magnitudeOf(const Point& point) { return point.cwiseAbs().maxCoeff(); }
double magnitudeOf(const std::pair<double, double>& row) { return std::max(std::abs(row.first), std::abs(row.second)); }
double magnitudeOf(const BoltPlace& place) { return place.head ? 0.0 : std::abs(place.s); }

template <typename Items>
double largestOf(const Items& items) {
    double magnitude = 0.0;
    for (const auto& item : items) magnitude = std::max(magnitude, magnitudeOf(item));
    return magnitude;
}

double magnitudeOf(const std::vector<Point>& points) { return largestOf(points); }
double magnitudeOf(const Table& table) { return largestOf(table); }
double magnitudeOf(const Stress& stress) { return largestOf(stress); }

template <typename Other>
double magnitudeOf(const Other&) {
    return 0.0;  // flags and texts
}

void checkMagnitude(const Field& field, const FieldValue& value, const std::string& pointer, CheckReport& report) {
    const double magnitude = std::visit([](const auto& held) { return magnitudeOf(held); }, value);
    if (magnitude > largest && std::isinf(field.range.most))  // others have a range of their own
        report.error(pointer, inQuotes(field.key) + " contains a number of magnitude " + shortest(magnitude),
                     "Give numbers of magnitude up to " + shortest(largest));
    const bool isPositive = !field.unit.empty() && field.range.leastExcluded && field.range.least == 0.0;
    const auto* number = std::get_if<double>(&value);
    if (isPositive && number && *number > 0.0 && *number < smallest)
        report.error(pointer, shortest(*number) + " is too small for " + inQuotes(field.key),
                     "Give a number from " + shortest(smallest));
}

void checkRange(const Field& field, double number, const std::string& pointer, CheckReport& report) {
    if (contains(field.range, number))
        return;
    const std::string unit = field.unit.empty() ? "" : " [" + std::string(field.unit) + "]";
    report.error(pointer, shortest(number) + " is out of range for " + inQuotes(field.key),
                 "Give a number " + rangeText(field.range) + unit);
}

void checkPoints(const Field& field, const std::vector<Point>& points, const std::string& pointer,
                 CheckReport& report) {
    for (std::size_t i = 0; i < points.size(); ++i)
        for (const double coordinate : {points[i].x(), points[i].y()})
            checkRange(field, coordinate, under(pointer, i), report);
}

void checkChildren(const Field& field, const void* object, const std::string& pointer, CheckReport& report) {
    const Children& children = field.children;
    for (std::size_t i = 0; i < children.count(object); ++i) {
        std::string place = pointer;
        if (field.kind == FieldKind::List)
            place = under(pointer, i);
        if (field.kind == FieldKind::Map)
            place = under(pointer, children.name(object, i));
        checkFields(children.structure(), children.item(object, i), place, report);
    }
}

// Reports a field that does not apply here but has a value other than its default. A field that is written in a file
// with its default value is reported by the reader.
void checkBelongs(const Structure& structure, const Field& field, const void* object, const std::string& pointer,
                  CheckReport& report) {
    if (field.only.key.empty() || applies(structure, field, object))
        return;
    const bool mayBeAbsent = field.kind == FieldKind::List || field.nullable;
    const bool says = hasChildren(field) ? mayBeAbsent && field.children.count(object) > 0
                                         : field.get(object) != defaultOf(structure, field);
    if (says)
        report.error(pointer, misplaced(field), "Remove it", {RepairKind::Omit, pointer});
}

void checkField(const Structure& structure, const Field& field, const void* object, const std::string& pointer,
                CheckReport& report) {
    checkBelongs(structure, field, object, pointer, report);
    if (hasChildren(field))
        return checkChildren(field, object, pointer, report);
    if (!field.get)
        return;
    const FieldValue value = field.get(object);
    const auto* text = std::get_if<std::string>(&value);
    if (field.required && text && text->empty())
        report.error(pointer, inQuotes(field.key) + " is empty", "Write " + std::string(field.help));
    checkValue(field, value, pointer, report);
}

}  // namespace

void checkValue(const Field& field, const FieldValue& value, const std::string& pointer, CheckReport& report) {
    if (!isFinite(value))
        return report.error(pointer, inQuotes(field.key) + " contains a number that is not finite",
                            "Give a finite number");
    checkMagnitude(field, value, pointer, report);
    if (const auto* number = std::get_if<double>(&value))
        checkRange(field, *number, pointer, report);
    if (const auto* place = std::get_if<BoltPlace>(&value); place && !place->head)
        checkRange(field, place->s, pointer, report);
    if (const auto* point = std::get_if<Point>(&value))
        for (const double coordinate : {point->x(), point->y()})
            checkRange(field, coordinate, pointer, report);
    if (const auto* points = std::get_if<std::vector<Point>>(&value))
        checkPoints(field, *points, pointer, report);
}

void checkFields(const Structure& structure, const void* object, const std::string& pointer, CheckReport& report) {
    for (const Field& field : structure.fields)
        checkField(structure, field, object, under(pointer, field.key), report);
}

}  // namespace keyblock
