// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/files/drawing/drawing.h"

#include <optional>
#include <string_view>

namespace keyblock {

/// Reads a drawing from the text of a DXF file. Inserted blocks are replaced by their contents. Every entity in model
/// space, and in the blocks inserted there, is either in `Drawing::lines` or in `Drawing::notTaken`.
/// \param sagitta the largest distance between a curve and the polyline that replaces it, in drawing units; null: 5e-4
///        times the longer side of the drawing.
Drawing readDxf(std::string_view text, std::optional<double> sagitta = std::nullopt);

}  // namespace keyblock
