// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Names in scenes, drawings and runs of others may contain characters that control a
// terminal: they could clear it, change its title, or hide the rest of a line. They
// are shown as escapes and never sent.
#pragma once

#include <string>
#include <string_view>

namespace keyblock {

/// The text (UTF-8) on one line: control characters (C0, DEL, C1), line and paragraph separators and characters that
/// override the direction of text become the escapes of JSON, such as `\n` and `\u001b`, so that JSON stays JSON. A
/// byte that is not UTF-8 becomes U+FFFD.
std::string visibleText(std::string_view text);

/// Like `visibleText`, but line feeds remain.
std::string visibleLines(std::string_view text);

}  // namespace keyblock
