// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Asks the X server directly whether a display offers OpenGL, because Qt terminates the
// program on a display that lists GLX but cannot draw with it.
#pragma once

namespace keyblock {

/// True if the display named by the environment variable DISPLAY can draw direct OpenGL into windows.
bool glxWorks();

}  // namespace keyblock
