// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/study/case_table.h"

#include "solver/files/read_error.h"

#include <charconv>
#include <fstream>
#include <optional>

namespace keyblock {

namespace {

namespace fs = std::filesystem;

std::string quoted(const std::string& cell) {
    if (cell.find_first_of(",\"") == std::string::npos) return cell;
    std::string text = "\"";
    for (const char c : cell) text += c == '"' ? std::string("\"\"") : std::string(1, c);
    return text + "\"";
}

[[noreturn]] void fail(const fs::path& table, const std::string& why) {
    throw CannotRead("cannot read " + table.string() + ": " + why + "; plan the sweep again");
}

/// Number of the case at the start of a line; none for the header.
std::optional<long> numberOf(const std::string& line) {
    long number = 0;
    const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), number);
    if (error != std::errc() || end == line.data()) return std::nullopt;
    return number;
}

/// First whole line that starts at or after a position; empty at the end of the file. Receives where it starts.
std::string lineFrom(std::ifstream& file, std::streamoff& position) {
    std::string line;
    file.clear();
    file.seekg(position > 0 ? position - 1 : 0);
    if (position > 0) {
        std::getline(file, line);  // the rest of the line before, or its end
        if (!file) return {};
        position = file.tellg();
    }
    return std::getline(file, line) ? line : std::string();
}

}  // namespace

std::string caseTable(const Study& study, const CasePlan& plan) {
    std::string text = "case";
    for (const StudyParameter& parameter : study.parameters) text += "," + quoted(parameter.name);
    text += '\n';
    for (long number = 1; number <= plan.cases(); ++number) {
        text += std::to_string(number);
        for (const std::string& cell : plan.row(number)) text += "," + quoted(cell);
        text += '\n';
    }
    return text;
}

std::vector<std::string> cellsOf(const std::string& line) {
    std::vector<std::string> cells(1);
    bool inQuotes = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const char c = line[i];
        if (inQuotes && c == '"' && i + 1 < line.size() && line[i + 1] == '"') cells.back() += line[++i];
        else if (c == '"') inQuotes = !inQuotes;
        else if (c == ',' && !inQuotes) cells.emplace_back();
        else cells.back() += c;
    }
    return cells;
}

std::vector<std::string> readCaseRow(const fs::path& table, long number, std::size_t parameters) {
    std::ifstream file(table, std::ios::binary);
    if (!file) fail(table, "the file cannot be opened");
    file.seekg(0, std::ios::end);
    std::streamoff from = 0, to = file.tellg();  // the row starts at `from` or later, and before `to`
    while (from < to) {
        const std::streamoff middle = from + (to - from) / 2;
        std::streamoff start = middle;
        const std::string line = lineFrom(file, start);
        const std::optional<long> found = numberOf(line);
        if (found == number) {
            std::vector<std::string> cells = cellsOf(line);
            if (cells.size() != parameters + 1) fail(table, "case " + std::to_string(number) + " is damaged");
            cells.erase(cells.begin());
            return cells;
        }
        if (line.empty() || start >= to || (found && *found > number)) to = middle;
        else from = start + 1;
    }
    fail(table, "it has no case " + std::to_string(number));
}

}  // namespace keyblock
