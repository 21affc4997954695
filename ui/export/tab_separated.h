// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A table on its way to the clipboard: spreadsheets put text with tabs into columns,
// text with commas into one.
#pragma once

#include <string>
#include <string_view>

namespace keyblock {

/// The CSV text with tabs between its values; quotes around a value are removed, a tab or line break within becomes a
/// space.
std::string tabSeparated(std::string_view csv);

}  // namespace keyblock
