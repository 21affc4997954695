// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The events of a run, on one timeline and as a list.
#pragma once

#include "ui/figure/figure.h"

namespace keyblock {

/// \throws CannotDraw for a run in which no stage was started.
Figure paintEvents(const RunSource& run, const FigureRequest& request);

}  // namespace keyblock
