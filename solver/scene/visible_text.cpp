// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/scene/visible_text.h"

#include "solver/scene/utf8.h"

namespace keyblock {

namespace {

bool isHidden(char32_t c) {
    const bool isControl = c < 0x20 || (c >= 0x7F && c <= 0x9F) || c == 0x2028 || c == 0x2029;
    const bool turnsText = (c >= 0x202A && c <= 0x202E) || (c >= 0x2066 && c <= 0x2069);
    return isControl || turnsText;
}

std::string escapeOf(char32_t c) {
    switch (c) {
        case U'\n': return "\\n";
        case U'\r': return "\\r";
        case U'\t': return "\\t";
        default: break;
    }
    constexpr std::string_view digits = "0123456789abcdef";
    std::string text = "\\u";
    for (const int shift : {12, 8, 4, 0}) text += digits[(c >> shift) & 0xFu];
    return text;
}

std::string visible(std::string_view text, bool keepsLines) {
    std::string result;
    result.reserve(text.size());
    while (!text.empty()) {
        const Utf8Character character = firstCharacter(text);
        if (!character.isValid) result += "\uFFFD";
        else if (isHidden(character.code) && !(keepsLines && character.code == U'\n'))
            result += escapeOf(character.code);
        else result += text.substr(0, character.length);
        text.remove_prefix(character.length);
    }
    return result;
}

}  // namespace

std::string visibleText(std::string_view text) { return visible(text, false); }
std::string visibleLines(std::string_view text) { return visible(text, true); }

}  // namespace keyblock
