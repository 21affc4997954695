// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/files/drawing/drawing.h"

#include <string>
#include <string_view>

namespace keyblock {

/// The lines of a list of joints or of bolts, in metres, on the layer `layer`; which of the two it is, its columns say,
/// and it is in `kind` (`joint`, `bolt`). `unit` is that of columns that say none; null: those are errors. Any
/// error, each with line and column, leaves nothing to be used.
Drawing readCsvList(std::string_view text, const std::string& layer, const UnitSymbol* unit);

}  // namespace keyblock
