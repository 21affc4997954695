// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Rates how well typed text matches the name of a command.
#pragma once

#include <QString>

namespace keyblock {

/// Rates how well a name matches the typed text; a higher number is a better match. Every typed word must occur in the
/// name. A match at the start of a word is best, then a match within a word, then a match whose letters are scattered
/// through the name in the same order. Returns −1 if there is no match, and 0 if nothing is typed.
int matchOf(const QString& typed, const QString& name);

}  // namespace keyblock
