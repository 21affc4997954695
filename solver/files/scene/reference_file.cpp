// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/files/scene/reference_file.h"

#include "solver/files/csv/csv_numbers.h"
#include "solver/files/text_file.h"
#include "solver/scene/suggest.h"

#include <algorithm>
#include <limits>

namespace keyblock {

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

bool isMissing(const CsvCell& cell) { return cell.text.empty() || plainName(cell.text) == "nan"; }

bool beginsLikeANumber(const std::string& text) {
    const auto first = text.find_first_not_of("+-.,");
    return first != std::string::npos && text[first] >= '0' && text[first] <= '9';
}

class ReferenceReader {
public:
    explicit ReferenceReader(const std::filesystem::path& file) {
        reading_.table.file = file.string();
        reading_.table.name = file.stem().string();
    }

    ReferenceReading read(std::string_view text) {
        CsvRows csv = readCsvRows(text);
        reading_.problems = std::move(csv.problems);
        numbers_.separatedBy(csv.separator);
        if (!hasErrors(reading_.problems)) readRows(csv);
        for (Problem& problem : reading_.problems) problem.file = reading_.table.file;
        return std::move(reading_);
    }

private:
    void tell(Severity severity, int line, std::string message, std::string remedy) {
        addProblem(reading_.problems, {severity, "", line, "", std::move(message), std::move(remedy)});
    }

    void readRows(const CsvRows& csv) {
        if (csv.rows.size() < 2)
            return tell(Severity::Error, 0, csv.rows.empty() ? "the file is empty" : "there are no rows under the header",
                        "Give a header such as opening_mm,load_kN and rows of numbers");
        const std::size_t columns = csv.rows.front().size();
        for (std::size_t i = 1; i < csv.rows.size() && !isFull(reading_.problems); ++i)
            if (const Problem problem = csvRowProblem(csv.rows[i], columns, csv.separator); !problem.message.empty())
                addProblem(reading_.problems, problem);
        if (hasErrors(reading_.problems)) return;
        for (std::size_t i = 0; i < columns; ++i) readColumn(csv, i);
        numbers_.finish();
        if (!hasErrors(reading_.problems) && reading_.table.columns.size() < 2)
            tell(Severity::Error, csv.rows.front().front().line, "a curve needs two columns of numbers",
                 "Give a header such as opening_mm,load_kN and rows of numbers");
    }

    void readColumn(const CsvRows& csv, std::size_t index) {
        const CsvCell& head = csv.rows.front()[index];
        const Title title = partedTitle(head.text);
        const std::string place = csvColumnText(index, head.text);
        const auto isWord = [&](const CsvRow& row) {
            return isMissing(row[index]) || !beginsLikeANumber(row[index].text);
        };
        if (title.unit.empty() && plainName(title.name) == "stage") return readStages(csv, index);
        if (title.unit.empty() && std::all_of(csv.rows.begin() + 1, csv.rows.end(), isWord))
            return tell(Severity::Warning, head.line, place + " contains no numbers and is not used", "Remove it");
        const std::optional<MeasureUnit> unit = measureUnitOf(title.unit.empty() ? "1" : title.unit);
        if (!unit)
            return tell(Severity::Error, head.line,
                        place + ": its unit " + inQuotes(title.unit) + " is not one of " + measureUnitWords(),
                        "Convert the numbers to one of them");
        if (title.name.empty())
            return tell(Severity::Error, head.line, place + " has no name", "Name it, as in opening_mm");
        ReferenceColumn column{head.text, title.name, unit->measure};
        for (std::size_t i = 1; i < csv.rows.size() && !isFull(reading_.problems); ++i)
            column.values.push_back(valueOf(csv.rows[i][index], place, unit->unit));
        reading_.table.columns.push_back(std::move(column));
    }

    double valueOf(const CsvCell& cell, const std::string& place, const Unit& unit) {
        double number = none;
        if (isMissing(cell) || !numbers_.read(cell, place, number)) return none;
        return toSi(number, unit);
    }

    void readStages(const CsvRows& csv, std::size_t index) {
        reading_.table.stages.clear();
        for (std::size_t i = 1; i < csv.rows.size(); ++i) reading_.table.stages.push_back(csv.rows[i][index].text);
    }

    ReferenceReading reading_;
    CsvNumbers numbers_{reading_.problems};
};

}  // namespace

ReferenceReading readReferenceTable(std::string_view text, const std::filesystem::path& file) {
    return ReferenceReader(file).read(text);
}

ReferenceReading readReferenceFile(const std::filesystem::path& path) {
    const TextFileLimits limits{std::uint64_t{64} << 20, "give the name of a CSV file", "give fewer rows"};
    return readReferenceTable(readTextFile(path, limits), path);
}

}  // namespace keyblock
