// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Converts names from other programs' files, which have various encodings, to UTF-8.
#pragma once

#include <string>
#include <string_view>

namespace keyblock {

/// Converts text to UTF-8 unless it is already valid UTF-8. Control characters, and bytes that the encoding does not
/// define, become `?`.
/// \param codePage the encoding of the text, as named in DXF files (`ANSI_1252`); empty: Windows 1252.
std::string asUtf8(std::string_view text, std::string_view codePage);

/// Returns the text with DXF escape sequences `\U+XXXX` replaced by the characters that they represent.
std::string withDxfEscapes(std::string_view text);

}  // namespace keyblock
