// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Names of the figures, known in every build, so that a build without figures can
// report that it has no figures rather than that the name is unknown.
#pragma once

#include <array>
#include <span>
#include <string_view>

namespace keyblock::cli {

/// Names of the figures, in the order of `FigureKind`.
inline std::span<const std::string_view> figureWords() {
    static constexpr std::array<std::string_view, 4> words{"section", "bolt", "curves", "events"};
    return words;
}

}  // namespace keyblock::cli
