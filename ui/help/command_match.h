// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How well what a person types fits the name of a command.
#pragma once

#include <QString>

namespace keyblock {

/// Each word typed must be found: best at the beginning of a word of the name, then anywhere in it, then as letters in
/// their order. −1: does not fit; more is better; 0 where nothing is typed.
int matchOf(const QString& typed, const QString& name);

}  // namespace keyblock
