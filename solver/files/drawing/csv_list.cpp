// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The header alone shows what a list contains and in which of four forms; all rows are
// then read in that form.
#include "solver/files/drawing/csv_list.h"

#include "solver/files/drawing/csv_columns.h"
#include "solver/files/csv/csv_numbers.h"
#include "solver/files/csv/csv_rows.h"
#include "solver/scene/suggest.h"
#include "solver/scene/units.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

namespace keyblock {

namespace {

using Kind = CsvColumnKind;

constexpr std::size_t mostRows = 200'000;  // as many as a drawing may have entities

enum class Form { Segments, Points, Ends, Directions };

class ListReader {
public:
    ListReader(const std::string& layer, const UnitSymbol* unit) : layer_(layer), unit_(unit) {}

    Drawing read(std::string_view text) {
        CsvRows csv = readCsvRows(text);
        drawing_.unit = lengthUnitOf("m");
        drawing_.problems = std::move(csv.problems);
        separator_ = csv.separator;
        numbers_.separatedBy(csv.separator);
        if (hasErrors(drawing_.problems)) return std::move(drawing_);
        if (csv.rows.empty())
            error(0, "the file is empty", "Give a header and rows; " + csvColumnForms());
        else if (readHeader(csv.rows.front()))
            readRows(csv.rows);
        if (hasErrors(drawing_.problems)) drawing_.lines.clear();
        return std::move(drawing_);
    }

private:
    void error(int line, std::string message, std::string remedy) {
        addProblem(drawing_.problems, {Severity::Error, "", line, "", std::move(message), std::move(remedy)});
    }

    bool has(Kind kind) const { return indexOf(kind) >= 0; }
    int indexOf(Kind kind) const {
        const auto found = std::find_if(columns_.begin(), columns_.end(),
                                        [&](const CsvColumn& column) { return column.kind == kind; });
        return found == columns_.end() ? -1 : static_cast<int>(found - columns_.begin());
    }
    std::string columnText(std::size_t index) const {
        return csvColumnText(index, columns_[index].title);
    }

    bool readHeader(const CsvRow& header) {
        const int line = header.front().line;
        for (const CsvCell& cell : header) columns_.push_back(readCsvColumn(cell.text));
        for (std::size_t i = 0; i < columns_.size(); ++i) checkColumn(i, line);
        if (hasErrors(drawing_.problems)) return false;
        if (has(Kind::FarX) && has(Kind::FarY) && has(Kind::HeadX) && has(Kind::HeadY))
            form_ = Form::Ends;
        else if (has(Kind::HeadX) && has(Kind::HeadY) && has(Kind::Length) && has(Kind::Angle))
            form_ = Form::Directions;
        else if (has(Kind::X1) && has(Kind::Y1) && has(Kind::X2) && has(Kind::Y2))
            form_ = Form::Segments;
        else if (has(Kind::X) && has(Kind::Y) && has(Kind::Name))
            form_ = Form::Points;
        else {
            error(line, "the header has columns of neither joints nor bolts", "Name the columns of " + csvColumnForms());
            return false;
        }
        tellUnused(line);
        return true;
    }

    void checkColumn(std::size_t i, int line) {
        const CsvColumn& column = columns_[i];
        if (!column.problem.empty()) error(line, columnText(i) + ": " + column.problem, "Give a unit in brackets");
        if (column.problem.empty() && isLength(column.kind) && !column.unit && !unit_)
            error(line, columnText(i) + " has no unit", "Write the unit as in " + inQuotes(column.title + " [m]") +
                                                             ", or give --units");
        if (column.kind != Kind::Unknown && indexOf(column.kind) != static_cast<int>(i))
            error(line, columnText(i) + " means the same as column " + std::to_string(indexOf(column.kind) + 1),
                  "Keep one of them");
    }

    bool isBolts() const { return form_ == Form::Ends || form_ == Form::Directions; }

    bool isUsed(Kind kind) const {
        if (kind == Kind::Name) return true;
        if (kind == Kind::Type || kind == Kind::Spacing || kind == Kind::Pretension) return isBolts();
        switch (form_) {
            case Form::Ends: return kind >= Kind::FarX && kind <= Kind::HeadY;
            case Form::Directions:
                return kind == Kind::HeadX || kind == Kind::HeadY || kind == Kind::Length || kind == Kind::Angle;
            case Form::Segments: return (kind >= Kind::X1 && kind <= Kind::Y2) || kind == Kind::Material;
            case Form::Points: return kind == Kind::X || kind == Kind::Y || kind == Kind::Material;
        }
        return false;
    }

    void tellUnused(int line) {
        for (std::size_t i = 0; i < columns_.size(); ++i)
            if (!isUsed(columns_[i].kind))
                addProblem(drawing_.problems, {Severity::Warning, "", line, "", columnText(i) + " is not used",
                                               "Rename it if it is one of these; " + csvColumnForms()});
    }

    void readRows(const std::vector<CsvRow>& rows) {
        if (rows.size() < 2) error(rows.front().front().line, "there are no rows under the header", "Add rows");
        if (rows.size() > mostRows + 1)
            return error(rows[mostRows + 1].front().line, "the number of rows exceeds " + std::to_string(mostRows),
                         "Give only those of the section");
        for (std::size_t i = 1; i < rows.size() && !isFull(drawing_.problems); ++i) readRow(rows[i]);
        numbers_.finish();
        for (const DrawnLine& line : drawing_.lines)
            if (line.points.size() < 2)
                error(line.place.line, "the joint " + inQuotes(line.name) + " has a single point", "Give two or more");
    }

    void readRow(const CsvRow& row) {
        const int line = row.front().line;
        if (const Problem problem = csvRowProblem(row, columns_.size(), separator_); !problem.message.empty())
            return addProblem(drawing_.problems, problem);
        row_ = &row;
        if (form_ == Form::Points) return addPoint(line);
        DrawnLine drawn = lineOf(line);
        if (form_ == Form::Segments) drawn.points = {point(Kind::X1, Kind::Y1), point(Kind::X2, Kind::Y2)};
        if (form_ == Form::Ends) drawn.points = {point(Kind::FarX, Kind::FarY), point(Kind::HeadX, Kind::HeadY)};
        if (form_ == Form::Directions) drawn.points = fromHead();
        if (drawn.points[0] == drawn.points[1] && !hasErrors(drawing_.problems))
            return error(line, "both ends are the same point", "Give two different points, or remove the row");
        if (has(Kind::Spacing) && isBolts()) drawn.boltSpacing = optional(Kind::Spacing);
        if (has(Kind::Pretension) && isBolts()) drawn.pretension = optional(Kind::Pretension);
        drawing_.lines.push_back(std::move(drawn));
    }

    DrawnLine lineOf(int line) const {
        DrawnLine drawn;
        drawn.layer = layer_;
        drawn.kind = isBolts() ? "bolt" : "joint";
        drawn.place = {line, ""};
        drawn.name = text(Kind::Name);
        drawn.material = text(Kind::Material);
        drawn.boltType = text(Kind::Type);
        drawn.headLast = isBolts();
        return drawn;
    }

    /// Consecutive rows with the same name are the points of one joint.
    void addPoint(int line) {
        const Point p = point(Kind::X, Kind::Y);
        const std::string name = text(Kind::Name);
        const bool goesOn = !drawing_.lines.empty() && drawing_.lines.back().name == name;
        if (!goesOn && !names_.insert(name).second)
            return error(line, "the joint " + inQuotes(name) + " continues here after another joint",
                         "Put its points in consecutive rows, or give it another name");
        if (!goesOn) drawing_.lines.push_back(lineOf(line));
        std::vector<Point>& points = drawing_.lines.back().points;
        if (!points.empty() && points.back() == p && !hasErrors(drawing_.problems))
            return error(line, "the point repeats the one before it", "Remove the row");
        points.push_back(p);
    }

    std::vector<Point> fromHead() {
        const Point head = point(Kind::HeadX, Kind::HeadY);
        const double length = number(Kind::Length);
        const double angle = number(Kind::Angle) * std::numbers::pi / 180.0;
        return {head + length * Point(std::cos(angle), std::sin(angle)), head};
    }

    std::string text(Kind kind) const {
        const int index = indexOf(kind);
        return index < 0 ? "" : (*row_)[index].text;
    }

    std::optional<double> optional(Kind kind) {
        return text(kind).empty() ? std::nullopt : std::optional(number(kind));
    }

    Point point(Kind x, Kind y) {
        const double first = number(x);
        return {first, number(y)};
    }

    /// Value in SI units; 0 after an error, which is reported.
    double number(Kind kind) {
        const auto index = static_cast<std::size_t>(indexOf(kind));
        const CsvCell& cell = (*row_)[index];
        const CsvColumn& column = columns_[index];
        double value = 0.0;
        if (!numbers_.read(cell, columnText(index), value)) return 0.0;
        if (isLength(kind)) return toSi(value, (column.unit ? column.unit : unit_)->unit);
        return kind == Kind::Pretension && column.unit ? toSi(value, column.unit->unit) : value;
    }

    std::string layer_;
    const UnitSymbol* unit_;
    Drawing drawing_;
    CsvNumbers numbers_{drawing_.problems};
    char separator_ = ',';
    std::vector<CsvColumn> columns_;
    Form form_ = Form::Segments;
    const CsvRow* row_ = nullptr;
    std::set<std::string> names_;
};

}  // namespace

Drawing readCsvList(std::string_view text, const std::string& layer, const UnitSymbol* unit) {
    return ListReader(layer, unit).read(text);
}

}  // namespace keyblock
