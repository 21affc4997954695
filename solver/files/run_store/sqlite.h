// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The little of SQLite that the run store needs, with ownership and errors in the
// language's own terms.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

struct sqlite3;
struct sqlite3_stmt;

namespace keyblock::sqlite {

/// What SQLite answered, with its result code.
struct Error : std::runtime_error {
    Error(int resultCode, const std::string& message, int systemErrorNumber = 0)
        : std::runtime_error(message), code(resultCode), systemError(systemErrorNumber) {}

    int code;
    int systemError;  // 0 where the system was not to blame
};

enum class Access { Create, Write, Read, ReadUnchanging };

/// A connection; closed when it goes. `ReadUnchanging` opens a file that no process writes, in a folder that cannot be
/// written. Throws `Error`.
class Database {
public:
    Database(const std::filesystem::path& path, Access access);

    /// Runs statements that give no rows.
    void run(const std::string& sql);
    sqlite3* handle() const { return handle_.get(); }

private:
    struct Close {
        void operator()(sqlite3* handle) const;
    };

    std::unique_ptr<sqlite3, Close> handle_;
};

/// A prepared statement, bound and stepped in order. Columns count from 0. Throws `Error`.
class Statement {
public:
    Statement(const Database& database, std::string_view sql);

    Statement& bind(std::int64_t value);
    Statement& bind(double value);  // NaN becomes NULL
    Statement& bind(std::string_view text);
    Statement& bind(std::span<const double> values);  // a BLOB of little-endian doubles
    Statement& bindBytes(std::string_view bytes);  // a BLOB
    /// Runs a statement that gives no row, and makes it ready for the next binding.
    void run();
    /// Steps to the next row; false after the last.
    bool next();

    std::int64_t integer(int column) const;
    double real(int column) const;  // NULL becomes NaN
    std::string text(int column) const;
    std::string bytes(int column) const;
    bool isNull(int column) const;
    /// Null when the BLOB is not a whole number of doubles.
    std::optional<std::vector<double>> doubles(int column) const;

private:
    struct Finalize {
        void operator()(sqlite3_stmt* statement) const;
    };

    void check(int code) const;
    sqlite3* connection() const;

    std::unique_ptr<sqlite3_stmt, Finalize> statement_;
    int bound_ = 0;
};

}  // namespace keyblock::sqlite
