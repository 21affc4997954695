// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Column titles of a list of joints or bolts, in the forms that are in common use:
// `x1`, `X start [mm]`, `head_x_m`.
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
    const UnitSymbol* unit = nullptr;  // unit of a length or force; null if the title gives none
    std::string title;
    std::string problem;  // message about an invalid unit; empty if there is none
};

/// Whether a column contains lengths or coordinates.
bool isLength(CsvColumnKind kind);

/// Reads a column title. It consists of a name and, optionally, a unit with or without brackets.
CsvColumn readCsvColumn(const std::string& title);

/// The preferred column titles, for messages.
std::string csvColumnForms();

}  // namespace keyblock
