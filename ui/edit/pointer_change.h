// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Records how JSON pointers change when entries of lists are removed, moved or renamed.
// Earlier pointers can then be mapped to the same objects, so that the selection is
// kept.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace keyblock {

/// The parts of a JSON pointer, with `~0` and `~1` decoded; empty for the whole scene.
std::vector<std::string> partsOf(std::string_view pointer);

/// The pointer without its last part; empty for the whole scene.
std::string parentOf(std::string_view pointer);

/// Maps a pointer that was valid before an edit to the corresponding pointer after it; null if the object no longer
/// exists.
using WhereNow = std::function<std::optional<std::string>(const std::string& pointer)>;

/// True if the set contains the pointer or one of its parents.
bool liesIn(const std::set<std::string>& pointers, std::string pointer);

/// Maps pointers that were valid before an edit to the corresponding pointers after it.
class PointerChange {
public:
    /// Records that entries of a list were removed, so that the entries after them moved up.
    /// \param list the pointer of the list. \param indices the indices of the removed entries. \param count the number
    /// of entries before the removal.
    void removed(const std::string& list, const std::vector<std::size_t>& indices, std::size_t count);

    /// Records that an entry was moved from index `from` to `to`; the entries in between moved by one position.
    void moved(const std::string& list, std::size_t from, std::size_t to);

    /// Records the removal of an object that is not in a list.
    void removed(const std::string& pointer);

    /// Records that an entry of a map was renamed.
    void renamed(const std::string& map, const std::string& from, const std::string& to);

    /// The current pointer to the object to which `pointer` referred before the edit; null if the object no longer
    /// exists.
    std::optional<std::string> now(std::string_view pointer) const;

    /// The inverse mapping, for undo.
    PointerChange reversed() const;

    bool empty() const { return parts_.empty(); }

private:
    std::map<std::string, std::optional<std::string>> parts_;  // earlier pointer → new last part; null: removed
};

}  // namespace keyblock
