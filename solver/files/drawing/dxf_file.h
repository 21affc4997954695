// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/files/drawing/drawing.h"

#include <optional>
#include <string_view>

namespace keyblock {

/// The lines of a DXF text, curves as points no edge of which lies farther off than `sagitta` [units of the drawing;
/// null: 5e-4 of the drawing's longer side], inserted blocks in their places. Every entity of the model and of the
/// blocks that it inserts is among the lines or among what is not taken.
Drawing readDxf(std::string_view text, std::optional<double> sagitta = std::nullopt);

}  // namespace keyblock
