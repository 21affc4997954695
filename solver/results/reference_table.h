// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Measured or published data to compare with a run: columns of numbers in SI units,
// each with its dimension (force, length, …) taken from its unit, so that a load in
// kN is compared with the forces of the run and never with its displacements.
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
    Measure measure = Measure::Number;  // distinguishes an energy from a moment, which have the same unit
    Unit unit{};
};

/// The unit with this name, e.g. `kN`, `N m` or `mm/m`, in upper or lower case; none if it is not a supported unit.
std::optional<MeasureUnit> measureUnitOf(std::string_view word);

/// Comma-separated names of the supported units, for messages.
std::string measureUnitWords();

/// The word for a measure in messages, e.g. `force` or `length`.
std::string_view wordOf(Measure measure);

/// A name in the form used to compare names: lower case, with each sequence of `_`, `-`, `.` and spaces replaced by one
/// space.
std::string plainName(std::string_view name);

struct Title {
    std::string name;  // `load`
    std::string unit;  // `kN`; empty if the title gives none
};

/// Splits a title such as `load_kN`, `Load (kN)`, `load [kN]` or `load kN` into name and unit.
Title partedTitle(std::string_view title);

struct ReferenceColumn {
    std::string title;  // as written in the file
    std::string name;  // the title without the unit
    Measure measure = Measure::Number;
    std::vector<double> values{};  // one per row [SI]; NaN for an empty cell
};

struct ReferenceTable {
    std::string file;  // file name for messages
    std::string name;  // display name: the file name without its extension
    std::vector<std::string> stages{};  // one per row, from the column named `stage`; empty without such a column
    std::vector<ReferenceColumn> columns{};
};

/// Writes the table in the form that `readReferenceTable` reads, with SI units in the column names.
void writeReferenceTable(const ReferenceTable& table, std::ostream& out);

}  // namespace keyblock
