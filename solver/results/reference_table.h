// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What others measured or published, to be compared with a run: columns of numbers in
// SI, each with the kind of measure that its unit says, so that a load in kN meets
// the forces of the run and never its displacements.
#pragma once

#include "solver/scene/units.h"

#include <optional>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

namespace keyblock {

enum class Measure { Number, Time, Length, Force, Moment, Energy };

struct MeasureUnit {
    Measure measure = Measure::Number;  // which tells an energy from a moment
    Unit unit{};
};

/// The unit of that name, `kN`, `N m` or `mm/m`, in either case; none if the tables of references have no such unit.
std::optional<MeasureUnit> measureUnitOf(std::string_view word);

/// The units' names, for people.
std::string measureUnitWords();

/// `force`, `length`, …, for people.
std::string_view wordOf(Measure measure);

/// A name for comparing: in lower case, and `_`, `-`, `.` and blanks are all one blank.
std::string plainName(std::string_view name);

struct Title {
    std::string name;  // `load`
    std::string unit;  // `kN`; empty: it says none
};

/// Parts a title as tables and charts write them: `load_kN`, `Load (kN)`, `load [kN]`, `load kN`.
Title partedTitle(std::string_view title);

struct ReferenceColumn {
    std::string title;  // as it was written
    std::string name;  // without the unit
    Measure measure = Measure::Number;
    std::vector<double> values{};  // by row [SI]; NaN where the cell is empty
};

struct ReferenceTable {
    std::string file;  // for messages
    std::string name;  // for people: the file's without its ending
    std::vector<std::string> stages{};  // by row, of a column of that name; empty: none
    std::vector<ReferenceColumn> columns{};
};

/// Writes the table as `reference_file` reads it: SI units in the column names.
void writeReferenceTable(const ReferenceTable& table, std::ostream& out);

}  // namespace keyblock
