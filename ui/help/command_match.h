// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How well typed text matches the name of a command.
#pragma once

#include <QString>

namespace keyblock {

/// Each typed word must be found: best at the start of a word of the name, then anywhere in it, then as letters in
/// order. −1: no match; higher is better; 0 if nothing is typed.
int matchOf(const QString& typed, const QString& name);

}  // namespace keyblock
