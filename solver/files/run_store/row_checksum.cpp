// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/files/run_store/row_checksum.h"

#include "solver/files/run_store/sqlite.h"

#include <sqlite3.h>

#include <bit>
#include <cstddef>
#include <cstdint>

namespace keyblock::sqlite {

namespace {

class Fnv1a {
public:
    void add(const void* bytes, std::size_t size) {
        const auto* byte = static_cast<const unsigned char*>(bytes);
        for (const auto* end = byte + size; byte != end; ++byte) hash_ = (hash_ ^ *byte) * prime;
    }
    /// Adds a number byte by byte, from the least significant one.
    template <typename Number>
    void addNumber(Number number) {
        for (std::size_t byte = 0; byte < sizeof number; ++byte)
            hash_ = (hash_ ^ (number >> (8 * byte) & 0xFF)) * prime;
    }
    std::uint64_t hash() const { return hash_; }

private:
    static constexpr std::uint64_t prime = 0x100000001B3;
    std::uint64_t hash_ = 0xCBF29CE484222325;
};

void addSizes(Fnv1a& sum, int position, std::size_t size) {
    sum.addNumber(static_cast<std::uint32_t>(position));
    sum.addNumber(static_cast<std::uint32_t>(size));
}

void addNumber(Fnv1a& sum, int position, std::uint64_t number) {
    addSizes(sum, position, sizeof number);
    sum.addNumber(number);
}

void addBytes(Fnv1a& sum, int position, const void* bytes, int size) {
    addSizes(sum, position, static_cast<std::size_t>(size));
    if (bytes) sum.add(bytes, static_cast<std::size_t>(size));
}

void rowChecksum(sqlite3_context* context, int count, sqlite3_value** values) {
    Fnv1a sum;
    for (int i = 0; i < count; ++i) {
        sqlite3_value* const value = values[i];
        switch (sqlite3_value_type(value)) {
            case SQLITE_NULL: break;
            case SQLITE_INTEGER: addNumber(sum, i, static_cast<std::uint64_t>(sqlite3_value_int64(value))); break;
            case SQLITE_FLOAT:  // SQLite stores -0.0 as 0
                addNumber(sum, i, std::bit_cast<std::uint64_t>(sqlite3_value_double(value) + 0.0));
                break;
            case SQLITE_TEXT: {
                const void* text = sqlite3_value_text(value);  // converts the value; the size is valid only after this call
                addBytes(sum, i, text, sqlite3_value_bytes(value));
                break;
            }
            default: {
                const void* blob = sqlite3_value_blob(value);
                addBytes(sum, i, blob, sqlite3_value_bytes(value));
                break;
            }
        }
    }
    sqlite3_result_int64(context, static_cast<sqlite3_int64>(sum.hash()));
}

}  // namespace

void addRowChecksum(sqlite3* connection) {
    constexpr int flags = SQLITE_UTF8 | SQLITE_DETERMINISTIC | SQLITE_DIRECTONLY;
    const int code = sqlite3_create_function_v2(connection, "row_checksum", -1, flags, nullptr, rowChecksum, nullptr,
                                                nullptr, nullptr);
    if (code != SQLITE_OK) throw Error(code, sqlite3_errmsg(connection));
}

}  // namespace keyblock::sqlite
