// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Asks the X server directly whether a display offers OpenGL, because Qt terminates the
// program on a display that lists GLX but cannot draw with it.
#pragma once

namespace keyblock {

/// True if direct OpenGL rendering into windows works on the display named by the environment variable DISPLAY.
bool glxWorks();

}  // namespace keyblock
