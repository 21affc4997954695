// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/files/drawing/drawing.h"

#include <optional>
#include <string_view>

namespace keyblock {

/// Reads the lines of a DXF file from its text, with inserted blocks at their positions. Every entity in model space,
/// and in the blocks inserted there, is either in `lines` or in `notTaken`.
/// \param sagitta the largest distance between a curve and the polyline that replaces it, in drawing units; null: 5e-4
///        times the longer side of the drawing.
Drawing readDxf(std::string_view text, std::optional<double> sagitta = std::nullopt);

}  // namespace keyblock
