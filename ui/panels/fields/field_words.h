// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Texts for the fields of the field table as shown in forms: labels, headings and
// units.
#pragma once

#include "ui/look/display.h"
#include "ui/panels/fields/object_at.h"

#include <QString>
#include <QStringList>

#include <string_view>
#include <vector>

namespace keyblock {

/// Label of a field, e.g. `Out-of-plane spacing` or `Young's modulus`.
QString labelOf(const Field& field);

/// Label of a field; for stresses it includes the sign convention.
QString labelOf(const Field& field, const Display& display);

/// Title of a structure, e.g. `Joint set`.
QString titleOf(const Structure& structure);

/// Number of objects as text, e.g. `3 joint sets` or `1 bolt`.
QString countedOf(const Structure& structure, int count);

/// Heading of the group that contains the field. Most structures have a single group, whose heading is the title of the
/// structure.
QString headingOf(const Structure& structure, const Field& field);

/// SI unit of the field for this object, in the form that `Display` expects. The field table may list two units (`N/m,
/// or N/m per m`); the properties of the object determine which one applies.
std::string_view unitOf(const ObjectAt& at, const Field& field);

/// SI units of the columns of a table of pairs; empty for any other field.
std::vector<std::string_view> columnUnits(const ObjectAt& at, const Field& field);

/// Headings of the columns of a table of pairs, e.g. `Time` and `Displacement`.
QStringList columnTitles(const Field& field);

/// Converts UTF-8 to a QString.
QString fromUtf8(std::string_view text);

}  // namespace keyblock
