// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Marks texts for the user in tables of the solver, which a window may translate.
#pragma once

#include <string_view>

namespace keyblock {

/// The text itself. Qt's lupdate finds the marked texts by the name of this function (target `texts`); both arguments
/// must be literals.
constexpr std::string_view translatable(std::string_view /*context*/, std::string_view text) { return text; }

}  // namespace keyblock
