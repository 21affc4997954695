// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How pointers change when entries of a list are removed, moved or renamed: earlier
// pointers are mapped to the same objects, so that the selection is kept.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace keyblock {

/// The parts of a JSON pointer, with `~0` and `~1` decoded. The pointer of the whole scene has none.
std::vector<std::string> partsOf(std::string_view pointer);

/// The pointer without its last part; empty for the whole scene.
std::string parentOf(std::string_view pointer);

/// The new pointer for an earlier one; none: the object is gone.
using WhereNow = std::function<std::optional<std::string>(const std::string& pointer)>;

/// True if the pointer, or a parent of it, is in the set.
bool liesIn(const std::set<std::string>& pointers, std::string pointer);

/// Changes of the entries of some lists and maps.
class PointerChange {
public:
    /// The entries of `list` (a pointer) at these indices, of `count`, were removed; the others moved up.
    void removed(const std::string& list, const std::vector<std::size_t>& indices, std::size_t count);

    /// The entry at `from` is now at `to`; those between moved up or down.
    void moved(const std::string& list, std::size_t from, std::size_t to);

    /// The object at `pointer`, which is not in a list, was removed.
    void removed(const std::string& pointer);

    /// The entry of a map was renamed.
    void renamed(const std::string& map, const std::string& from, const std::string& to);

    /// The new pointer for `pointer`; none: the object is gone.
    std::optional<std::string> now(std::string_view pointer) const;

    /// The inverse, for undo.
    PointerChange reversed() const;

    bool empty() const { return parts_.empty(); }

private:
    std::map<std::string, std::optional<std::string>> parts_;  // earlier pointer → new last part; none: gone
};

}  // namespace keyblock
