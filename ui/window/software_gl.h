// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Keeps OpenGL drawing without a graphics card from slowing down runs, which use the
// same processors.
#pragma once

namespace keyblock {

/// Limits Mesa's software rendering to processors that a run does not need. With as many threads as processors, Mesa
/// interrupts the thread of the run a hundred times a second and displaces its data from the cache. A value that the
/// user has set in LP_NUM_THREADS is kept. \pre the application object has not been created yet.
void leaveProcessorsToRuns();

}  // namespace keyblock
