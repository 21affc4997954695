// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/files/text_encoding.h"

#include "solver/files/json/json_tree.h"

#include <iconv.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>

namespace keyblock {

namespace {

void appendUtf8(std::string& text, std::uint32_t letter) {
    if (letter < 0x80) {
        text += static_cast<char>(letter);
    } else if (letter < 0x800) {
        text += static_cast<char>(0xC0 | (letter >> 6));
        text += static_cast<char>(0x80 | (letter & 0x3F));
    } else {
        text += static_cast<char>(0xE0 | (letter >> 12));
        text += static_cast<char>(0x80 | ((letter >> 6) & 0x3F));
        text += static_cast<char>(0x80 | (letter & 0x3F));
    }
}

/// Name that iconv uses for the code page of a DXF file.
std::string iconvName(std::string_view codePage) {
    const auto number = codePage.find_first_of("0123456789");
    return number == std::string_view::npos ? "CP1252" : "CP" + std::string(codePage.substr(number));
}

std::string converted(std::string_view text, std::string_view codePage) {
    const iconv_t conversion = ::iconv_open("UTF-8", iconvName(codePage).c_str());
    std::string result;
    for (std::size_t at = 0; at < text.size();) {
        std::array<char, 8> out{};
        bool done = false;
        for (std::size_t length = 1; length <= 2 && !done && at + length <= text.size(); ++length) {
            if (conversion == reinterpret_cast<iconv_t>(-1)) break;
            std::string bytes(text.substr(at, length));
            char* in = bytes.data();
            char* put = out.data();
            std::size_t left = bytes.size(), room = out.size();
            ::iconv(conversion, nullptr, nullptr, nullptr, nullptr);
            done = ::iconv(conversion, &in, &left, &put, &room) != static_cast<std::size_t>(-1) && left == 0;
            if (done) {
                result.append(out.data(), out.size() - room);
                at += length;
            }
        }
        if (!done) {
            result += static_cast<unsigned char>(text[at]) < 0x80 ? text[at] : '?';
            ++at;
        }
    }
    if (conversion != reinterpret_cast<iconv_t>(-1)) ::iconv_close(conversion);
    return result;
}

}  // namespace

std::string asUtf8(std::string_view text, std::string_view codePage) {
    std::string result = isUtf8(text) ? std::string(text) : converted(text, codePage);
    std::replace_if(result.begin(), result.end(), [](char c) { return (c >= 0 && c < ' ') || c == '\x7F'; }, '?');
    return result;
}

std::string withDxfEscapes(std::string_view text) {
    std::string result;
    for (std::size_t at = 0; at < text.size();) {
        std::uint32_t letter = 0;
        if (text.substr(at).starts_with("\\U+") && at + 7 <= text.size()) {
            const char* digits = text.data() + at + 3;
            const auto [end, failure] = std::from_chars(digits, digits + 4, letter, 16);
            if (failure == std::errc() && end == digits + 4 && letter >= ' ' && (letter < 0xD800 || letter > 0xDFFF)) {
                appendUtf8(result, letter);
                at += 7;
                continue;
            }
        }
        result += text[at++];
    }
    return result;
}

}  // namespace keyblock
