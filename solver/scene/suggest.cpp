// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Similarity is measured by the Levenshtein distance: the number of insertions,
// deletions and replacements.
#include "solver/scene/suggest.h"

#include <algorithm>
#include <cstddef>

namespace keyblock {

namespace {

constexpr std::size_t longestQuoted = 60;
constexpr std::size_t mostListed = 12;
constexpr std::size_t longestCompared = 60;
constexpr std::size_t mostCompared = 5000;  // names; more take longer than a suggestion is worth

// The number of edits between two texts, or `most` if there are at least as many: each row of the comparison has only
// larger numbers than the least one of the row before.
std::size_t editDistance(std::string_view a, std::string_view b, std::size_t most) {
    if (std::max(a.size(), b.size()) - std::min(a.size(), b.size()) >= most) return most;
    std::vector<std::size_t> row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j)
        row[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
            diagonal = row[j];
            row[j] = std::min({row[j] + 1, row[j - 1] + 1, replaced});
        }
        if (*std::min_element(row.begin(), row.end()) >= most) return most;
    }
    return row[b.size()];
}

// A name that begins with `text`, which is assumed to be incomplete; empty if there is none.
std::string_view nameBeginningWith(std::string_view text, const std::vector<std::string_view>& names) {
    constexpr std::size_t shortestBeginning = 3;
    for (const std::string_view name : names)
        if (text.size() >= shortestBeginning && name.size() > text.size() && name.starts_with(text))
            return name;
    return {};
}

// Cuts between characters, never inside one: the continuation bytes of a UTF-8 character begin with the bits 10.
std::string_view shortened(std::string_view text, std::size_t length) {
    while (length > 0 && (static_cast<unsigned char>(text[length]) & 0xC0) == 0x80)
        --length;
    return text.substr(0, length);
}

}  // namespace

std::string inQuotes(std::string_view text) {
    if (text.size() <= longestQuoted)
        return "'" + std::string(text) + "'";
    return "'" + std::string(shortened(text, longestQuoted)) + "…'";
}

std::string listed(const std::vector<std::string_view>& names) {
    if (names.empty())
        return "none";
    std::string text;
    for (std::size_t i = 0; i < std::min(names.size(), mostListed); ++i)
        text += (i == 0 ? "" : ", ") + inQuotes(names[i]);
    return names.size() > mostListed ? text + ", …" : text;
}

std::string_view nearestName(std::string_view text, const std::vector<std::string_view>& names) {
    if (text.size() > longestCompared)
        return {};
    std::string_view nearest;
    std::size_t least = std::max<std::size_t>(2, text.size() / 3) + 1;
    for (std::size_t i = 0; i < std::min(names.size(), mostCompared); ++i) {
        const std::string_view name = names[i];
        if (name.size() > 2 * longestCompared)
            continue;
        const std::size_t distance = editDistance(text, name, least);
        if (distance < least && distance < std::max(name.size(), text.size())) {
            least = distance;
            nearest = name;
        }
    }
    return nearest.empty() ? nameBeginningWith(text, names) : nearest;
}

std::string suggestion(std::string_view text, const std::vector<std::string_view>& names) {
    const std::string_view nearest = nearestName(text, names);
    if (!nearest.empty())
        return "Did you mean " + inQuotes(nearest) + "?";
    return names.empty() ? "None is defined" : "Available: " + listed(names);
}

}  // namespace keyblock
