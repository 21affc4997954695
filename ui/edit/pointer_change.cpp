// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/edit/pointer_change.h"

#include "solver/scene/pointer.h"

#include <algorithm>

namespace keyblock {

std::vector<std::string> partsOf(std::string_view pointer) {
    std::vector<std::string> parts;
    for (std::size_t i = 0; i < pointer.size(); ++i) {
        if (pointer[i] == '/')
            parts.emplace_back();
        else if (parts.empty())
            parts.emplace_back(1, pointer[i]);  // no leading slash: kept as it is
        else if (pointer[i] == '~' && i + 1 < pointer.size() && (pointer[i + 1] == '0' || pointer[i + 1] == '1'))
            parts.back() += pointer[++i] == '0' ? '~' : '/';
        else
            parts.back() += pointer[i];
    }
    return parts;
}

std::string parentOf(std::string_view pointer) {
    const std::size_t slash = pointer.rfind('/');
    return slash == std::string_view::npos ? std::string() : std::string(pointer.substr(0, slash));
}

bool liesIn(const std::set<std::string>& pointers, std::string pointer) {
    for (; !pointer.empty(); pointer = parentOf(pointer))
        if (pointers.contains(pointer)) return true;
    return false;
}

void PointerChange::removed(const std::string& list, const std::vector<std::size_t>& indices, std::size_t count) {
    std::size_t now = 0;
    for (std::size_t i = 0; i < count; ++i) {
        if (std::find(indices.begin(), indices.end(), i) != indices.end())
            parts_[under(list, i)] = std::nullopt;
        else
            parts_[under(list, i)] = std::to_string(now++);
    }
}

void PointerChange::moved(const std::string& list, std::size_t from, std::size_t to) {
    parts_[under(list, from)] = std::to_string(to);
    for (std::size_t i = std::min(from, to); i <= std::max(from, to); ++i)
        if (i != from) parts_[under(list, i)] = std::to_string(from < to ? i - 1 : i + 1);
}

void PointerChange::removed(const std::string& pointer) { parts_[pointer] = std::nullopt; }

void PointerChange::renamed(const std::string& map, const std::string& from, const std::string& to) {
    parts_[under(map, from)] = to;
}

std::optional<std::string> PointerChange::now(std::string_view pointer) const {
    std::string before, after;
    for (const std::string& part : partsOf(pointer)) {
        before = under(before, part);
        const auto found = parts_.find(before);
        if (found != parts_.end() && !found->second) return std::nullopt;
        after = under(after, found == parts_.end() ? part : *found->second);
    }
    return after;
}

PointerChange PointerChange::reversed() const {
    PointerChange back;
    for (const auto& [before, part] : parts_)
        if (const auto after = part ? now(before) : std::nullopt) back.parts_[*after] = partsOf(before).back();
    return back;
}

}  // namespace keyblock
