// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/files/scene/record_file.h"

#include "solver/files/regular_file.h"
#include "solver/scene/suggest.h"

#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>
#include <optional>

namespace keyblock {

namespace {

constexpr std::size_t longestFile = std::size_t{32} << 20;  // bytes
constexpr std::size_t mostFaults = 10;
constexpr std::string_view header = "time_s,a";
constexpr std::string_view asItShouldBe = "Write the header time_s,a and rows like 0.02,-0.153, with decimal points";

std::string_view trimmed(std::string_view text) {
    const auto first = text.find_first_not_of(" \t\r");
    return first == std::string_view::npos ? std::string_view{}
                                           : text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

std::vector<std::string_view> split(std::string_view text, char separator) {
    std::vector<std::string_view> parts;
    for (;;) {
        const auto end = text.find(separator);
        parts.push_back(text.substr(0, end));
        if (end == std::string_view::npos)
            return parts;
        text.remove_prefix(end + 1);
    }
}

/// The lines of a text, without empty ones at the end.
std::vector<std::string_view> linesOf(std::string_view text) {
    constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";
    if (text.starts_with(byteOrderMark))
        text.remove_prefix(byteOrderMark.size());
    std::vector<std::string_view> lines = split(text, '\n');
    while (!lines.empty() && trimmed(lines.back()).empty())
        lines.pop_back();
    return lines;
}

std::string atRow(std::size_t row) { return "row " + std::to_string(row); }

/// Number that fills the whole cell; NaN and infinity count as numbers here.
std::optional<double> numberIn(std::string_view cell) {
    if (cell.size() > 1 && cell.front() == '+' && cell[1] != '-' && cell[1] != '+')
        cell.remove_prefix(1);
    double number = 0.0;
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), number);
    if (error != std::errc() || end != cell.data() + cell.size())
        return {};
    return number;
}

class RecordReader {
public:
    RecordReading read(std::string_view text) {
        if (text.find('\0') != std::string_view::npos) {
            fail("the file is not UTF-8 text (it contains zero bytes, as UTF-16 does)", "Save it as CSV in UTF-8");
            return std::move(reading_);
        }
        const std::vector<std::string_view> lines = linesOf(text);
        if (lines.empty())
            fail("the file is empty", std::string(asItShouldBe));
        else if (checkHeader(trimmed(lines.front())))
            readRows(lines);
        if (!reading_.faults.empty())
            reading_.record.clear();
        return std::move(reading_);
    }

private:
    bool checkHeader(std::string_view line) {
        const std::vector<std::string_view> cells = split(line, ',');
        if (cells.size() == 2 && trimmed(cells[0]) == "time_s" && trimmed(cells[1]) == "a")
            return true;
        fail(atRow(1) + ": the header is " + inQuotes(line) + ", but must be " + inQuotes(header),
             line.find(';') != std::string_view::npos
                 ? "Separate columns by commas, not semicolons, and write decimal points"
                 : std::string(asItShouldBe));
        return false;
    }

    void readRows(const std::vector<std::string_view>& lines) {
        if (lines.size() < 2)
            fail("the record has a header but no rows", "Give at least two rows of time and value");
        for (std::size_t i = 1; i < lines.size() && reading_.faults.size() < mostFaults; ++i)
            if (!readRow(trimmed(lines[i]), i + 1))
                return;
        if (lines.size() == 2 && reading_.faults.empty())
            fail("the record has a single row", "Give at least two rows of time and value");
    }

    /// \return false if the rest of the file would only repeat the same error.
    bool readRow(std::string_view line, std::size_t row) {
        if (line.empty())
            return stop(row, "the row is empty", "Remove it: a gap in a record is rarely intended");
        if (line.find(';') != std::string_view::npos)
            return stop(row, "the row has a semicolon: " + inQuotes(line),
                        "Separate columns by commas, not semicolons, and write decimal points");
        if (line.find('"') != std::string_view::npos)
            return stop(row, "the row has quotes: " + inQuotes(line), "Write plain numbers with decimal points");
        if (line.find('\t') != std::string_view::npos)
            return stop(row, "the row has a tab: " + inQuotes(line), "Separate columns by commas");
        const std::vector<std::string_view> cells = split(line, ',');
        if (cells.size() != 2)
            return stop(row, "the row has " + std::to_string(cells.size()) + " columns instead of 2: " +
                                 inQuotes(line),
                        cells.size() > 2 ? "Write decimal points, not commas, and two columns per row"
                                         : std::string(asItShouldBe));
        const auto time = cell(cells[0], row, 1), value = cell(cells[1], row, 2);
        if (time && value)
            add(*time, *value, row);
        return true;
    }

    std::optional<double> cell(std::string_view text, std::size_t row, int column) {
        const std::string place = atRow(row) + ", column " + std::to_string(column) + ": ";
        const std::optional<double> number = numberIn(trimmed(text));
        if (!number)
            fail(place + inQuotes(trimmed(text)) + " is not a number", "Write a number like -0.153 or 1.5e-3");
        else if (!std::isfinite(*number))
            fail(place + inQuotes(trimmed(text)) + " is not finite (NaN, infinite)", "Give a finite number");
        else
            return number;
        return {};
    }

    void add(double time, double value, std::size_t row) {
        const std::string place = atRow(row) + ", column 1: the time ";
        if (time < 0.0)
            fail(place + "is negative", "Count seconds from the start of the stage");
        else if (!reading_.record.empty() && !(time > reading_.record.back().first))
            fail(place + "does not increase", "Sort the rows by time and give each time only once");
        reading_.record.emplace_back(time, value);
    }

    bool stop(std::size_t row, const std::string& message, std::string remedy) {
        fail(atRow(row) + ": " + message, std::move(remedy));
        return false;
    }

    void fail(std::string message, std::string remedy) {
        reading_.faults.push_back({std::move(message), std::move(remedy)});
    }

    RecordReading reading_;
};

RecordReading unreadable(std::string message, std::string remedy) {
    return {{}, {{std::move(message), std::move(remedy)}}};
}

}  // namespace

RecordReading readRecordText(std::string_view text) { return RecordReader().read(text); }

RecordReading readRecordFile(const std::filesystem::path& path) {
    if (const std::string special = specialFileAt(path); !special.empty())
        return unreadable("this is " + special + ", not a file", "Give a CSV file");
    errno = 0;
    std::ifstream file(path, std::ios::binary);
    if (!file)
        return unreadable("the file cannot be opened: " + std::string(std::strerror(errno)),
                          "Give its path relative to the scene file, and check that you may read it");
    std::string text(longestFile + 1, '\0');
    file.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(file.gcount());
    if (text.size() > longestFile)
        return unreadable("the file is longer than " + std::to_string(longestFile >> 20) + " MB",
                          "Resample the record");
    return readRecordText(text);
}

}  // namespace keyblock
