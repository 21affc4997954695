// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Marks user-visible texts in tables of the solver, so that a user interface can translate them.
#pragma once

#include <string_view>

namespace keyblock {

/// Returns `text` unchanged. Qt's lupdate (build target `texts`) finds texts to be translated by the name of this
/// function, so both arguments must be string literals.
constexpr std::string_view translatable(std::string_view /*context*/, std::string_view text) { return text; }

}  // namespace keyblock
