// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Without a graphics card, OpenGL is computed on the processors that a run needs too.
#pragma once

namespace keyblock {

/// Restricts Mesa's drawing to processors that a run does not need: with as many threads as processors it interrupts
/// the run's thread a hundred times a second and evicts its cache. Call before the application object exists; a value
/// set by the user (LP_NUM_THREADS) is kept.
void leaveProcessorsToRuns();

}  // namespace keyblock
