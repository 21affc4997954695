// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The checksum of a row of a run store: the SQL function `row_checksum(value, …)`, with
// which rows are written, and a function that checks a row as it is read. SQLite checks
// its own structures only: without it a flipped bit in a result would be shown as
// another number.
#pragma once

#include <cstdint>

struct sqlite3;
struct sqlite3_stmt;

namespace keyblock::sqlite {

/// Makes `row_checksum` known to a connection: the hash XXH3 (64 bits, no seed), as a signed integer, of all its
/// arguments that are not NULL. Each contributes its position from 0, the length of its value (4 bytes each) and the
/// value: 8 bytes of an integer or double, or the bytes of a text or BLOB, all little-endian. -0.0 counts as 0.0. A
/// cryptographic hash would guard no better against damage, and takes longer; with CRC-32 or FNV-1a a large store takes
/// a tenth or a fifth longer to open than without checksums.
/// \throws Error
void addRowChecksum(sqlite3* connection);

/// The checksum of the first columns of the current row of a statement.
std::int64_t rowChecksum(sqlite3_stmt* row, int columns);

}  // namespace keyblock::sqlite
