// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Keys of a scene are free text, so they are escaped when they are added to a
// pointer.
#include "solver/scene/pointer.h"

namespace keyblock {

std::string under(std::string_view parent, std::string_view key) {
    std::string pointer(parent);
    pointer += '/';
    for (const char c : key) {
        if (c == '~')
            pointer += "~0";
        else if (c == '/')
            pointer += "~1";
        else
            pointer += c;
    }
    return pointer;
}

std::string under(std::string_view parent, std::size_t index) { return under(parent, std::to_string(index)); }

bool isWithin(std::string_view pointer, std::string_view ancestor) {
    return pointer.starts_with(ancestor) && (pointer.size() == ancestor.size() || pointer[ancestor.size()] == '/');
}

}  // namespace keyblock
