// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The small part of SQLite that the run store needs, with C++ ownership and
// exceptions.
#pragma once

#include <chrono>
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

/// An error reported by SQLite, with its result code.
struct Error : std::runtime_error {
    Error(int resultCode, const std::string& message, int systemErrorNumber = 0)
        : std::runtime_error(message), code(resultCode), systemError(systemErrorNumber) {}

    int code;
    int systemError;  // system error number; 0 if the system reported no error
};

enum class Access { Create, Write, Read, ReadUnchanging };

/// Number of progress reports of SQLite since a statement began, and the number at which it is interrupted, which grows
/// with the file.
struct Effort {
    std::filesystem::path file;
    std::int64_t spent = 0, allowed = 0;
};

/// A connection to a database, closed by the destructor. `Access::ReadUnchanging` is for a file that no process is
/// writing to, in a folder without write permission. The file may come from any source: triggers, views and functions
/// in its schema are not executed, and a statement that takes much longer than reading the whole file ends with an
/// error. Statements may use the function `row_checksum` (row_checksum.h).
/// \throws Error
class Database {
public:
    Database(const std::filesystem::path& path, Access access);

    /// Runs SQL statements that return no rows.
    void run(const std::string& sql);
    /// Sets how long statements wait while another program has the database locked; 5 s if it is not called.
    void waitForLocks(std::chrono::milliseconds patience);
    sqlite3* handle() const { return handle_.get(); }
    Effort& effort() const { return *effort_; }

private:
    struct Close {
        void operator()(sqlite3* handle) const;
    };

    std::unique_ptr<Effort> effort_;  // outlives the handle, which refers to it
    std::unique_ptr<sqlite3, Close> handle_;
};

/// A prepared statement. Values are bound to its parameters in order; columns are numbered from 0. \throws Error
class Statement {
public:
    Statement(const Database& database, std::string_view sql);

    Statement& bind(std::int64_t value);
    Statement& bind(double value);  // NaN becomes NULL
    Statement& bind(std::string_view text);
    Statement& bind(std::span<const double> values);  // a BLOB of little-endian doubles
    Statement& bindBytes(std::string_view bytes);  // a BLOB
    /// Runs a statement that returns no rows, and resets it so that parameters can be bound again.
    void run();
    /// Steps to the next row; returns false after the last row.
    bool next();

    std::int64_t integer(int column) const;
    double real(int column) const;  // NULL becomes NaN
    std::string text(int column) const;
    std::string bytes(int column) const;
    bool isNull(int column) const;
    /// Checksum of the first columns of the row (row_checksum.h).
    std::int64_t checksum(int columns) const;
    /// The numbers in a BLOB column; none if the size of the BLOB is not a multiple of the size of a double.
    std::optional<std::vector<double>> doubles(int column) const;

private:
    struct Finalize {
        void operator()(sqlite3_stmt* statement) const;
    };

    void check(int code) const;
    sqlite3* connection() const;

    std::unique_ptr<sqlite3_stmt, Finalize> statement_;
    Effort& effort_;
    int bound_ = 0;
};

}  // namespace keyblock::sqlite
