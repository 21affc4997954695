// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads UTF-8 text character by character.
#pragma once

#include <cstddef>
#include <string_view>

namespace keyblock {

struct Utf8Character {
    char32_t code = 0;
    std::size_t length = 1;  // bytes
    bool isValid = false;  // false: the first byte begins no character; the length is then 1
};

/// The first character of a text. Overlong forms, surrogates and values above U+10FFFF are not valid.
/// \pre the text is not empty
Utf8Character firstCharacter(std::string_view text);

}  // namespace keyblock
