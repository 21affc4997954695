// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Names in tables that a spreadsheet would take for a formula. They are marked as text,
// because a scene may come from others.
#pragma once

#include <string>
#include <string_view>

namespace keyblock {

/// The text of a cell as a spreadsheet may read it: a text that begins with `=`, `+`, `-`, `@`, a tab or a line break,
/// and is not a number, would be a formula there and gets an apostrophe before it, as does one that begins with such an
/// apostrophe already.
std::string withoutFormula(std::string_view text);

/// The text that `withoutFormula` marked; all other texts as they are.
std::string_view asBeforeMarking(std::string_view cell);

}  // namespace keyblock
