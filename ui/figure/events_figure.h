// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What let go in a run, on one line of time and as a list.
#pragma once

#include "ui/figure/figure.h"

namespace keyblock {

/// \throws CannotDraw for a run in which nothing was begun.
Figure paintEvents(const RunSource& run, const FigureRequest& request);

}  // namespace keyblock
