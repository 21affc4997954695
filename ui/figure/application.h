// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The single Qt application object, on the platform that needs no display.
#pragma once

namespace keyblock {

/// Creates it on the first call. Fonts and hash order are then the same in every process.
void needApplication();

}  // namespace keyblock
