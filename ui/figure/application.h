// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The single Qt application object, with the `offscreen` platform, which needs no
// display.
#pragma once

namespace keyblock {

/// Creates the application object on the first call. Also ensures that fonts and the iteration order of hash tables are
/// the same in every process.
void needApplication();

}  // namespace keyblock
