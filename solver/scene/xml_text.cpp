// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/scene/xml_text.h"

#include "solver/scene/utf8.h"

namespace keyblock {

namespace {

bool isForbiddenInXml(char32_t c) {
    return (c < 0x20 && c != U'\t' && c != U'\n' && c != U'\r') || c == 0xFFFE || c == 0xFFFF;
}

}  // namespace

std::string withoutXmlForbidden(std::string_view text) {
    std::string result;
    result.reserve(text.size());
    while (!text.empty()) {
        const Utf8Character character = firstCharacter(text);
        if (!character.isValid) result += "\uFFFD";
        else if (!isForbiddenInXml(character.code)) result += text.substr(0, character.length);
        text.remove_prefix(character.length);
    }
    return result;
}

std::string xmlText(std::string_view text) {
    std::string result;
    for (const char c : withoutXmlForbidden(text)) switch (c) {
            case '<': result += "&lt;"; break;
            case '>': result += "&gt;"; break;
            case '&': result += "&amp;"; break;
            case '"': result += "&quot;"; break;
            case '\'': result += "&#39;"; break;
            default: result += c;
        }
    return result;
}

}  // namespace keyblock
