// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Figure with the diagram of one bolt.
#pragma once

#include "ui/figure/figure.h"

namespace keyblock {

/// Draws the requested bolt or, if none is requested, the bolt with the largest axial force.
/// \throws CannotDraw if the run has no bolts, or none at the requested time.
Figure paintBolt(const RunSource& run, const FigureRequest& request);

}  // namespace keyblock
