// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Names in files that are XML (SVG, VTK), so that every reader takes the file and no
// name becomes an element of it.
#pragma once

#include <string>
#include <string_view>

namespace keyblock {

/// The text (UTF-8) without the characters that XML 1.0 forbids even as references: control characters other than tab
/// and line breaks, U+FFFE, U+FFFF. A byte that is not UTF-8 becomes U+FFFD.
std::string withoutXmlForbidden(std::string_view text);

/// The text for the contents of an element or an attribute in quotes: `& < > " '` become references, and forbidden
/// characters are left out.
std::string xmlText(std::string_view text);

}  // namespace keyblock
