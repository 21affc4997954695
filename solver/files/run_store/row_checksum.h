// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The SQL function `row_checksum(value, …)`, with which rows of a run store are written
// and checked. SQLite checks its own structures only: without it a flipped bit in a
// result would be shown as another number.
#pragma once

struct sqlite3;

namespace keyblock::sqlite {

/// Makes `row_checksum` known to a connection: the 64-bit FNV-1a hash (Fowler, Noll and Vo), as a signed integer, of all
/// its arguments that are not NULL. Each contributes its position from 0, the length of its value (4 bytes each) and the
/// value: 8 bytes of an integer or double, or the bytes of a text or BLOB, all little-endian. -0.0 counts as 0.0. The
/// hash changes with every single byte; a cryptographic one would guard no better against damage, and takes longer to
/// set up than a small store to read.
/// \throws Error
void addRowChecksum(sqlite3* connection);

}  // namespace keyblock::sqlite
