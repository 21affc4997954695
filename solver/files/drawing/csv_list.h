// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/files/drawing/drawing.h"

#include <string>
#include <string_view>

namespace keyblock {

/// Reads a list of joints or of bolts; the columns determine which, and `DrawnLine::kind` is set accordingly. The lines
/// are in metres. Errors give the line and column; if there are any, the drawing must not be used.
/// \param layer the layer assigned to all lines.
/// \param unit the length unit for columns whose title gives none; null: such columns are errors.
Drawing readCsvList(std::string_view text, const std::string& layer, const UnitSymbol* unit);

}  // namespace keyblock
