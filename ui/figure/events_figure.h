// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Figure with the events of a run, on a timeline and as a list.
#pragma once

#include "ui/figure/figure.h"

namespace keyblock {

/// Draws the events. \throws CannotDraw if no stage of the run has started.
Figure paintEvents(const RunSource& run, const FigureRequest& request);

}  // namespace keyblock
