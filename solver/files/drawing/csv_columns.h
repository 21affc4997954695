// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the columns of a list of joints or bolts are called, in the plain forms that
// people use: `x1`, `X start [mm]`, `head_x_m`.
#pragma once

#include "solver/files/drawing/drawing.h"

#include <string>
#include <string_view>

namespace keyblock {

enum class CsvColumnKind {
    Name, X, Y, X1, Y1, X2, Y2, FarX, FarY, HeadX, HeadY, Length, Angle, Material, Type, Spacing, Pretension, Unknown
};

struct CsvColumn {
    CsvColumnKind kind = CsvColumnKind::Unknown;
    const UnitSymbol* unit = nullptr;  // of a length or a force, where the title says one
    std::string title;
    std::string problem;  // with its unit, for people; empty: none
};

/// Whether a column holds a length.
bool isLength(CsvColumnKind kind);

/// Reads a title: a name, and a unit in brackets or at the end.
CsvColumn readCsvColumn(const std::string& title);

/// The names that `readCsvColumn` knows best, for people.
std::string csvColumnForms();

}  // namespace keyblock
