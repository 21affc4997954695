// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/files/drawing/csv_columns.h"

#include "solver/files/drawing/dxf_entities.h"
#include "solver/scene/suggest.h"

#include <algorithm>
#include <map>

namespace keyblock {

namespace {

using Kind = CsvColumnKind;

/// Column kinds by title. The words of a title are in lower case and sorted, so that `x start` and `start x` are the
/// same.
const std::map<std::string, Kind>& names() {
    static const std::map<std::string, Kind> all = [] {
        std::map<std::string, Kind> table{
            {"name", Kind::Name},     {"id", Kind::Name},         {"label", Kind::Name},  {"no", Kind::Name},
            {"number", Kind::Name},   {"joint", Kind::Name},      {"bolt", Kind::Name},   {"x", Kind::X},
            {"y", Kind::Y},           {"length", Kind::Length},   {"l", Kind::Length},    {"angle", Kind::Angle},
            {"material", Kind::Material}, {"joint material", Kind::Material}, {"type", Kind::Type},
            {"bolt type", Kind::Type}, {"spacing", Kind::Spacing}, {"of out plane spacing", Kind::Spacing},
            {"pretension", Kind::Pretension}, {"preload", Kind::Pretension}};
        const auto pair = [&](Kind x, Kind y, std::initializer_list<std::string> places) {
            for (const std::string& place : places) {
                std::string withX = place < "x" ? place + " x" : "x " + place;
                std::string withY = place < "y" ? place + " y" : "y " + place;
                table[withX] = x;
                table[withY] = y;
            }
        };
        for (const std::string digit : {"1", "a", "0"}) {
            table["x" + digit] = Kind::X1;
            table["y" + digit] = Kind::Y1;
        }
        for (const std::string digit : {"2", "b"}) {
            table["x" + digit] = Kind::X2;
            table["y" + digit] = Kind::Y2;
        }
        pair(Kind::X1, Kind::Y1, {"1", "start", "from", "begin"});
        pair(Kind::X2, Kind::Y2, {"2", "end", "to"});
        pair(Kind::FarX, Kind::FarY, {"far", "toe", "end far"});
        pair(Kind::HeadX, Kind::HeadY, {"head", "collar", "plate"});
        return table;
    }();
    return all;
}

/// Unit for N, kN or MN in lower case; null for any other word.
const UnitSymbol* forceUnitOf(std::string_view lower) {
    for (const char* symbol : {"N", "kN", "MN"})
        if (lowerCase(symbol) == lower) return findUnit(symbol);
    return nullptr;
}

std::string cleared(std::string_view text) {
    std::string words;
    for (const char c : text) {
        const bool gap = c == '_' || c == '-' || c == ' ' || c == '.' || c == '\t';
        if (!gap)
            words += c;
        else if (!words.empty() && words.back() != ' ')
            words += ' ';
    }
    while (!words.empty() && words.back() == ' ') words.pop_back();
    return words;
}

std::string sortedWords(const std::string& words) {
    std::vector<std::string> list(1);
    for (const char c : words)
        if (c == ' ')
            list.emplace_back();
        else
            list.back() += c;
    std::sort(list.begin(), list.end());
    std::string sorted;
    for (const std::string& word : list) sorted += (sorted.empty() ? "" : " ") + word;
    return sorted;
}

/// Removes the unit from a title such as `x1 [mm]`, `x1 (mm)` or `x1_mm` and returns it; empty if there is none.
std::string takeUnit(std::string& title) {
    for (const auto& [open, close] : {std::pair{'[', ']'}, std::pair{'(', ')'}}) {
        const auto from = title.find(open), to = title.find(close);
        if (from == std::string::npos || to == std::string::npos || to < from) continue;
        const std::string unit = cleared(title.substr(from + 1, to - from - 1));
        title.erase(from);
        return unit;
    }
    const std::string words = cleared(title);
    const auto gap = words.rfind(' ');
    if (gap == std::string::npos) return {};
    const std::string last = words.substr(gap + 1), lower = lowerCase(last);
    if (!lengthUnitOf(lower) && !forceUnitOf(lower) && lower != "deg") return {};
    title = words.substr(0, gap);
    return last;
}

void readUnit(const std::string& unit, CsvColumn& column) {
    const std::string lower = lowerCase(unit);
    const bool angle = column.kind == Kind::Angle, force = column.kind == Kind::Pretension;
    column.unit = force ? forceUnitOf(lower) : lengthUnitOf(lower);
    if (isLength(column.kind) && !column.unit)
        column.problem = "its unit " + inQuotes(unit) + " is not one of " + lengthUnitWords();
    if (angle && lower != "deg" && lower != "°" && lower != "degrees")
        column.problem = "its unit " + inQuotes(unit) + " is not degrees";
    if (force && !column.unit)
        column.problem = "its unit " + inQuotes(unit) + " is not one of N, kN, MN";
}

}  // namespace

bool isLength(CsvColumnKind kind) {
    return kind != Kind::Name && kind != Kind::Angle && kind != Kind::Material && kind != Kind::Type &&
           kind != Kind::Pretension && kind != Kind::Unknown;
}

CsvColumn readCsvColumn(const std::string& title) {
    CsvColumn column;
    column.title = title;
    std::string name = title;
    const std::string unit = takeUnit(name);
    const auto found = names().find(sortedWords(lowerCase(cleared(name))));
    if (found == names().end()) return column;
    column.kind = found->second;
    if (!unit.empty()) readUnit(unit, column);
    return column;
}

std::string csvColumnForms() {
    return "joints: x1, y1, x2, y2, or name, x, y with a row for each point; bolts: far_x, far_y, head_x, head_y, or "
           "head_x, head_y, length, angle; also name, joint_material, type, spacing, pretension";
}

}  // namespace keyblock
