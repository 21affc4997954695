// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A wrapper that hides the buffer of std::to_chars.
#include "solver/scene/number_text.h"

#include <array>
#include <charconv>

namespace keyblock {

std::string shortest(double number) {
    std::array<char, 32> buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number).ptr;
    return {buffer.data(), end};
}

}  // namespace keyblock
