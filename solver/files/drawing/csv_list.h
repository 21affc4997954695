// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/files/drawing/drawing.h"

#include <string>
#include <string_view>

namespace keyblock {

/// Reads a list of joints or a list of bolts; the column titles show which it is. `DrawnLine::kind` is set accordingly.
/// The coordinates in the result are in metres. If `Drawing::problems` contains an error, which gives the line and
/// column, the drawing must not be used.
/// \param layer the layer assigned to all lines.
/// \param unit the length unit for columns whose title gives none; null: such columns are errors.
Drawing readCsvList(std::string_view text, const std::string& layer, const UnitSymbol* unit);

}  // namespace keyblock
