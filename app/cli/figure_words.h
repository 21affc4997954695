// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The figures by name, known to every build: one without figures says that it has
// none, not that it does not know the word.
#pragma once

#include <array>
#include <span>
#include <string_view>

namespace keyblock::cli {

/// In the order of `FigureKind`.
inline std::span<const std::string_view> figureWords() {
    static constexpr std::array<std::string_view, 4> words{"section", "bolt", "curves", "events"};
    return words;
}

}  // namespace keyblock::cli
