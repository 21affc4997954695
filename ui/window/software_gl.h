// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where a machine has no graphics card, OpenGL is worked out by the processors that
// a run needs, too.
#pragma once

namespace keyblock {

/// Keeps Mesa's drawing to the processors that a run does not need: with as many threads as processors it takes the run's
/// from it a hundred times a second, and what that one had in its cache. Before the application is made; a choice of the
/// user's own (LP_NUM_THREADS) stands.
void leaveProcessorsToRuns();

}  // namespace keyblock
