// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Converts a table for the clipboard: spreadsheets split text at tabs into columns, but
// not at commas.
#pragma once

#include <string>
#include <string_view>

namespace keyblock {

/// The CSV text with tabs between its values; quotes around a value are removed, a tab or line break within becomes a
/// space.
std::string tabSeparated(std::string_view csv);

}  // namespace keyblock
