// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Asks X directly whether a display offers OpenGL: Qt ends the program on a display
// that lists GLX but cannot draw with it.
#pragma once

namespace keyblock {

/// True if the display named by DISPLAY can draw direct OpenGL into windows.
bool glxWorks();

}  // namespace keyblock
