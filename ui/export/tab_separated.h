// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Converts a table for the clipboard: spreadsheets split pasted text into columns at
// tabs, but not at commas.
#pragma once

#include <string>
#include <string_view>

namespace keyblock {

/// Converts CSV text to tab-separated values. Quotes around values are removed; a tab or line break within a value
/// becomes a space.
std::string tabSeparated(std::string_view csv);

}  // namespace keyblock
