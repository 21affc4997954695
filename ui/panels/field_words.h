// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Texts of the field table as forms show them: labels, headings and units.
#pragma once

#include "ui/look/display.h"
#include "ui/panels/object_at.h"

#include <QString>
#include <QStringList>

#include <string_view>
#include <vector>

namespace keyblock {

/// `Out-of-plane spacing`, `Young's modulus`.
QString labelOf(const Field& field);

/// The same with the sign convention for stresses.
QString labelOf(const Field& field, const Display& display);

/// `Joint set`.
QString titleOf(const Structure& structure);

/// `3 joint sets`, `1 bolt`.
QString countedOf(const Structure& structure, int count);

/// The heading above a field of the object; most structures have a single one, their title.
QString headingOf(const Structure& structure, const Field& field);

/// SI unit of the field in this object, as `Display` takes it; the table may allow two (`N/m, or N/m per m`).
std::string_view unitOf(const ObjectAt& at, const Field& field);

/// SI units of the columns of a table of pairs; empty: none.
std::vector<std::string_view> columnUnits(const ObjectAt& at, const Field& field);

/// Headings of the columns of a table of pairs: `Time`, `Displacement`.
QStringList columnTitles(const Field& field);

/// Text from UTF-8.
QString fromUtf8(std::string_view text);

}  // namespace keyblock
