// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/tab_separated.h"

namespace keyblock {

std::string tabSeparated(std::string_view csv) {
    std::string text;
    text.reserve(csv.size());
    bool quoted = false;
    for (std::size_t i = 0; i < csv.size(); ++i) {
        const char c = csv[i];
        if (c == '"' && quoted && i + 1 < csv.size() && csv[i + 1] == '"') text += csv[++i];
        else if (c == '"') quoted = !quoted;
        else if (quoted) text += c == '\t' || c == '\n' || c == '\r' ? ' ' : c;
        else text += c == ',' ? '\t' : c;
    }
    return text;
}

}  // namespace keyblock
