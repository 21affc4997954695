// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The strip of one bolt on a sheet.
#pragma once

#include "ui/figure/figure.h"

namespace keyblock {

/// Of the bolt that was asked for, else of the one with the largest axial force.
/// \throws CannotDraw for a run or a moment without bolts.
Figure paintBolt(const RunSource& run, const FigureRequest& request);

}  // namespace keyblock
