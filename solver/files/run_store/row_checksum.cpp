// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/files/run_store/row_checksum.h"

#include "solver/files/run_store/sqlite.h"

#define XXH_STATIC_LINKING_ONLY  // for the size of a state, so that it needs no heap
#include <sqlite3.h>
#include <xxhash.h>

#include <bit>
#include <cstddef>
#include <cstdint>

namespace keyblock::sqlite {

namespace {

class Hash {
public:
    Hash() { XXH3_64bits_reset(&state_); }
    void addNumber(int position, std::uint64_t number) {
        const struct {
            std::uint32_t position, size;
            std::uint64_t number;
        } value{static_cast<std::uint32_t>(position), sizeof number, number};
        add(&value, sizeof value);
    }
    void addBytes(int position, const void* bytes, int size) {
        const std::uint32_t head[] = {static_cast<std::uint32_t>(position), static_cast<std::uint32_t>(size)};
        add(head, sizeof head);
        if (size > 0) add(bytes, static_cast<std::size_t>(size));
    }
    std::int64_t value() const { return static_cast<std::int64_t>(XXH3_64bits_digest(&state_)); }

private:
    void add(const void* bytes, std::size_t size) { XXH3_64bits_update(&state_, bytes, size); }

    XXH3_state_t state_;
};

/// An argument of the SQL function.
struct Argument {
    sqlite3_value* value;

    int type() const { return sqlite3_value_type(value); }
    std::int64_t integer() const { return sqlite3_value_int64(value); }
    double real() const { return sqlite3_value_double(value); }
    const void* text() const { return sqlite3_value_text(value); }
    const void* blob() const { return sqlite3_value_blob(value); }
    int size() const { return sqlite3_value_bytes(value); }
};

/// A column of the current row of a statement.
struct Column {
    sqlite3_stmt* row;
    int column;

    int type() const { return sqlite3_column_type(row, column); }
    std::int64_t integer() const { return sqlite3_column_int64(row, column); }
    double real() const { return sqlite3_column_double(row, column); }
    const void* text() const { return sqlite3_column_text(row, column); }
    const void* blob() const { return sqlite3_column_blob(row, column); }
    int size() const { return sqlite3_column_bytes(row, column); }
};

template <typename Value>
void add(Hash& hash, int position, const Value& value) {
    switch (value.type()) {
        case SQLITE_NULL: break;
        case SQLITE_INTEGER: hash.addNumber(position, static_cast<std::uint64_t>(value.integer())); break;
        case SQLITE_FLOAT:  // SQLite stores -0.0 as 0
            hash.addNumber(position, std::bit_cast<std::uint64_t>(value.real() + 0.0));
            break;
        default: {
            // Reading converts the value; the size is valid only after that.
            const void* const bytes = value.type() == SQLITE_TEXT ? value.text() : value.blob();
            hash.addBytes(position, bytes, value.size());
        }
    }
}

void rowChecksumFunction(sqlite3_context* context, int count, sqlite3_value** values) {
    Hash hash;
    for (int i = 0; i < count; ++i) add(hash, i, Argument{values[i]});
    sqlite3_result_int64(context, hash.value());
}

}  // namespace

void addRowChecksum(sqlite3* connection) {
    constexpr int flags = SQLITE_UTF8 | SQLITE_DETERMINISTIC | SQLITE_DIRECTONLY;
    const int code = sqlite3_create_function_v2(connection, "row_checksum", -1, flags, nullptr, rowChecksumFunction,
                                                nullptr, nullptr, nullptr);
    if (code != SQLITE_OK) throw Error(code, sqlite3_errmsg(connection));
}

std::int64_t rowChecksum(sqlite3_stmt* row, int columns) {
    Hash hash;
    for (int i = 0; i < columns; ++i) add(hash, i, Column{row, i});
    return hash.value();
}

}  // namespace keyblock::sqlite
