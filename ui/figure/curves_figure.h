// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Curves of a run's history on a sheet.
#pragma once

#include "ui/figure/figure.h"

namespace keyblock {

/// \throws CannotDraw for a run without a history, and for an unknown monitor.
Figure paintCurves(const RunSource& run, const FigureRequest& request);

}  // namespace keyblock
