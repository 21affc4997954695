// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Whether an X display offers OpenGL, asked of X itself: Qt ends the program on a
// display that has GLX by name but nothing to draw with.
#pragma once

namespace keyblock {

/// True when the display named by DISPLAY can draw direct OpenGL into windows.
bool glxWorks();

}  // namespace keyblock
