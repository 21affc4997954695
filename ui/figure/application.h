// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The single Qt application object, with the `offscreen` platform, which needs no
// display.
#pragma once

namespace keyblock {

/// Creates the application object on the first call. Fonts and the iteration order of hash tables are then the same in
/// every process.
void needApplication();

}  // namespace keyblock
