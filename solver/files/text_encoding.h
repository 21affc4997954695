// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Names in files of others come in many encodings; ours are UTF-8.
#pragma once

#include <string>
#include <string_view>

namespace keyblock {

/// A text that is UTF-8 as it is; another one from the code page (`ANSI_1252`, as DXF names it; empty: Windows 1252).
/// Bytes that mean nothing there become `?`, and so do control characters.
std::string asUtf8(std::string_view text, std::string_view codePage);

/// With `\U+XXXX` of DXF turned into the letters it represents.
std::string withDxfEscapes(std::string_view text);

}  // namespace keyblock
