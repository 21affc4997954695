// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/results/reference_table.h"

#include "solver/results/csv.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace keyblock {

namespace {

struct Word {
    std::string_view text;
    Measure measure = Measure::Number;
};

constexpr std::array<Word, 24> unitNames{{{"s", Measure::Time},
                                          {"ms", Measure::Time},
                                          {"min", Measure::Time},
                                          {"m", Measure::Length},
                                          {"cm", Measure::Length},
                                          {"mm", Measure::Length},
                                          {"um", Measure::Length},
                                          {"µm", Measure::Length},
                                          {"ft", Measure::Length},
                                          {"inch", Measure::Length},
                                          {"N", Measure::Force},
                                          {"kN", Measure::Force},
                                          {"MN", Measure::Force},
                                          {"N m", Measure::Moment},
                                          {"kN m", Measure::Moment},
                                          {"MN m", Measure::Moment},
                                          {"J", Measure::Energy},
                                          {"kJ", Measure::Energy},
                                          {"MJ", Measure::Energy},
                                          {"m/m"},
                                          {"mm/m"},
                                          {"%"},
                                          {"1"},
                                          {"-"}}};

/// Indexed by `Measure`.
constexpr std::array<std::string_view, 6> measureWords{"number", "time", "length", "force", "moment", "energy"};
constexpr std::array<std::string_view, 6> siSuffixes{"", "_s", "_m", "_N", "_Nm", "_J"};

std::string inLower(std::string_view text) {
    std::string lower(text);
    for (char& c : lower)
        if (static_cast<unsigned char>(c) < 0x80) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return lower;
}

std::string trimmed(std::string_view text) {
    const auto first = text.find_first_not_of(" _");
    if (first == std::string_view::npos) return {};
    return std::string(text.substr(first, text.find_last_not_of(" _") - first + 1));
}

/// `kn m` and `kN·m` both become `knm`.
std::string bare(std::string_view word) {
    std::string text = inLower(word);
    for (const std::string_view dot : {"·", "*", " ", "."})
        for (auto at = text.find(dot); at != std::string::npos; at = text.find(dot)) text.erase(at, dot.size());
    return text;
}

/// True for a unit that may follow a name without brackets.
bool standsAlone(const MeasureUnit& unit) {
    return unit.measure != Measure::Number;
}

}  // namespace

std::optional<MeasureUnit> measureUnitOf(std::string_view word) {
    const auto found = std::ranges::find(unitNames, bare(word), [](const Word& known) { return bare(known.text); });
    if (found == unitNames.end()) return std::nullopt;
    return MeasureUnit{found->measure, readUnit(found->text).value_or(Unit{})};  // `-` denotes a pure number
}

std::string measureUnitWords() {
    std::string text;
    for (const Word& word : unitNames) text += (text.empty() ? "" : ", ") + std::string(word.text);
    return text;
}

std::string_view wordOf(Measure measure) { return measureWords[static_cast<std::size_t>(measure)]; }

std::string plainName(std::string_view name) {
    std::string plain;
    for (const char c : inLower(name)) {
        const bool gap = c == '_' || c == '-' || c == '.' || c == ' ' || c == '\t';
        if (!gap)
            plain += c;
        else if (!plain.empty() && plain.back() != ' ')
            plain += ' ';
    }
    while (!plain.empty() && plain.back() == ' ') plain.pop_back();
    return plain;
}

Title partedTitle(std::string_view title) {
    for (const auto& [open, close] : {std::pair{'[', ']'}, std::pair{'(', ')'}}) {
        const auto from = title.rfind(open), to = title.rfind(close);
        if (from == std::string_view::npos || to == std::string_view::npos || to < from) continue;
        return {trimmed(title.substr(0, from)), trimmed(title.substr(from + 1, to - from - 1))};
    }
    const auto gap = title.find_last_of("_ ");
    if (gap == std::string_view::npos) return {trimmed(title), ""};
    const std::string_view last = title.substr(gap + 1);
    const std::optional<MeasureUnit> unit = measureUnitOf(last);
    if (!unit || !standsAlone(*unit)) return {trimmed(title), ""};
    return {trimmed(title.substr(0, gap)), std::string(last)};
}

void writeReferenceTable(const ReferenceTable& table, std::ostream& out) {
    CsvWriter csv(out);
    if (!table.stages.empty()) csv.text("stage");
    for (const ReferenceColumn& column : table.columns)
        csv.text(column.name + std::string(siSuffixes[static_cast<std::size_t>(column.measure)]));
    csv.endRow();
    const std::size_t rows = table.columns.empty() ? 0 : table.columns.front().values.size();
    for (std::size_t row = 0; row < rows; ++row) {
        if (!table.stages.empty()) csv.text(table.stages[row]);
        for (const ReferenceColumn& column : table.columns) csv.number(column.values[row]);
        csv.endRow();
    }
}

}  // namespace keyblock
