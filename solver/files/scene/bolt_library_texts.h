// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The texts of resources/bolts/*.json. The build generates the source file that
// belongs to this header, so that the program needs no path to these data at run time.
#pragma once

#include <span>
#include <string_view>

namespace keyblock {

/// Contents of the files resources/bolts/*.json, one string per file, sorted by file name.
std::span<const std::string_view> boltLibraryTexts();

}  // namespace keyblock
