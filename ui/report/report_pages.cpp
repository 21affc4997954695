// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/report_pages.h"

#include <algorithm>
#include <sstream>

namespace keyblock {

namespace {

bool beginsLetter(char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }

/// Moves the longest beginning of `word` that fits to the end of `line`; at least one letter if `line` is empty.
void moveLetters(std::string& word, std::string& line, const TextStyle& style, double width) {
    std::size_t end = 0;
    for (std::size_t next = 1; next <= word.size(); ++next) {
        if (next < word.size() && !beginsLetter(word[next])) continue;
        if (textWidth(line + word.substr(0, next), style) > width && !(line.empty() && end == 0)) break;
        end = next;
    }
    line += word.substr(0, end);
    word.erase(0, end);
}

}  // namespace

std::vector<std::string> brokenLines(const std::string& text, const TextStyle& style, double width) {
    std::vector<std::string> lines{""};
    std::istringstream words(text);
    for (std::string word; words >> word;) {
        const std::string longer = lines.back().empty() ? word : lines.back() + " " + word;
        if (textWidth(longer, style) <= width) {
            lines.back() = longer;
            continue;
        }
        if (!lines.back().empty()) lines.emplace_back();
        while (textWidth(word, style) > width) {
            moveLetters(word, lines.back(), style, width);
            if (word.empty()) break;
            lines.emplace_back();
        }
        lines.back() += word;
    }
    return lines;
}

PageLayout layOut(const std::vector<PagePiece>& pieces) {
    using namespace report_page;
    PageLayout layout;
    double y = top;
    for (std::size_t i = 0; i < pieces.size();) {
        std::size_t end = i;  // the pieces from i to end belong together
        while (pieces[end].staysWithNext && end + 1 < pieces.size()) ++end;
        double group = 0.0;
        for (std::size_t k = i; k <= end; ++k) group += pieces[k].height;
        if (y > top && y + group > bottom) {
            ++layout.pages;
            y = top;
            if (pieces[i].head) {
                layout.pieces.push_back({layout.pages - 1, y, pieces[i].head.get()});
                y += pieces[i].head->height;
            }
        }
        for (; i <= end; ++i) {
            if (pieces[i].isGap && y == top) continue;
            if (pieces[i].section >= 0) layout.sections.push_back(layout.pages - 1);
            layout.pieces.push_back({layout.pages - 1, y, &pieces[i]});
            y += pieces[i].height;
        }
    }
    return layout;
}

}  // namespace keyblock
