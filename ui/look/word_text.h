// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Words of scene files as they are shown in the window.
#pragma once

#include <QString>

#include <string_view>

namespace keyblock {

/// `clockwise` for `cw`, `D-shape` for `d-shape`; other words are unchanged.
QString wordText(std::string_view word);

}  // namespace keyblock
