// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Memory that has been freed but is still kept by the C library for later requests of
// the same thread: after a run on a thread of its own, most of what the run needed.
#pragma once

namespace keyblock {

/// Gives freed memory back to the system. To be called on the thread of long work, when it has ended: takes milliseconds.
void returnFreeMemory();

}  // namespace keyblock
