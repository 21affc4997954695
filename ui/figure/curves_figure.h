// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Figure with the curves of a run's history.
#pragma once

#include "ui/figure/figure.h"

namespace keyblock {

/// Draws the requested curves. \throws CannotDraw if the run has no history or the monitor is unknown.
Figure paintCurves(const RunSource& run, const FigureRequest& request);

}  // namespace keyblock
