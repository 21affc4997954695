// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where things went when a list lost, moved or renamed an entry: pointers of
// before lead to the same things afterwards, so that a selection stays on what a
// person chose.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace keyblock {

/// The parts of a JSON pointer, `~0` and `~1` read. The pointer of the whole scene has none.
std::vector<std::string> partsOf(std::string_view pointer);

/// The pointer without its last part; empty for the whole scene.
std::string parentOf(std::string_view pointer);

/// Where what a pointer led to is now; none: it is gone.
using WhereNow = std::function<std::optional<std::string>(const std::string& pointer)>;

/// True when the pointer, or one above it, is among them.
bool liesIn(const std::set<std::string>& pointers, std::string pointer);

/// What became of the entries of some lists and maps.
class PointerChange {
public:
    /// The entries of `list` (a pointer) that had these places are gone; of `count` before, the others closed up.
    void removed(const std::string& list, const std::vector<std::size_t>& indices, std::size_t count);

    /// The entry at `from` stands at `to`, those between moved up or down.
    void moved(const std::string& list, std::size_t from, std::size_t to);

    /// Something else that `pointer` leads to has gone: no list closes up.
    void removed(const std::string& pointer);

    /// The entry of a map has another name.
    void renamed(const std::string& map, const std::string& from, const std::string& to);

    /// Where what `pointer` led to is now; none: it is gone.
    std::optional<std::string> now(std::string_view pointer) const;

    /// The way back, for undo.
    PointerChange reversed() const;

    bool empty() const { return parts_.empty(); }

private:
    std::map<std::string, std::optional<std::string>> parts_;  // pointer before → last part now; none: gone
};

}  // namespace keyblock
