// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The diagram of one bolt on a sheet.
#pragma once

#include "ui/figure/figure.h"

namespace keyblock {

/// Of the requested bolt, else of the one with the largest axial force. \throws CannotDraw for a run or a time without
/// bolts.
Figure paintBolt(const RunSource& run, const FigureRequest& request);

}  // namespace keyblock
