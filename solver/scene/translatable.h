// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Marks user-visible texts in tables of the solver, so that a user interface can translate them.
#pragma once

#include <string_view>

namespace keyblock {

/// Returns the text unchanged. Qt's lupdate (target `texts`) finds marked texts by the name of this function; both
/// arguments must be string literals.
constexpr std::string_view translatable(std::string_view /*context*/, std::string_view text) { return text; }

}  // namespace keyblock
