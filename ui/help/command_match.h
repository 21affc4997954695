// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Rates how well typed text matches the name of a command.
#pragma once

#include <QString>

namespace keyblock {

/// Every typed word must occur in the name. A match at the start of a word rates best, then one within a word, then one
/// whose letters are scattered through the name in the same order. Returns −1 if there is no match, 0 if nothing is
/// typed, and otherwise a rating; higher is better.
int matchOf(const QString& typed, const QString& name);

}  // namespace keyblock
