// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Doubles are stored as they are in memory, on machines whose byte order is that of a
// run store.
#include "solver/files/run_store/sqlite.h"

#include "solver/files/run_store/row_checksum.h"

#include <sqlite3.h>

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cstring>
#include <limits>

namespace keyblock::sqlite {

namespace {

static_assert(std::endian::native == std::endian::little);  // here and in row_checksum.cpp

constexpr std::chrono::seconds busyWait{5};
constexpr int progressEvery = 10000;  // instructions of SQLite's virtual machine
// Instructions that a statement may take, plus those per byte of the file: reading a row takes fewer than one per byte.
constexpr std::int64_t leastAllowed = 20000000, allowedPerByte = 8;

/// Throws the connection's message about its last failure.
[[noreturn]] void fail(int code, sqlite3* connection) {
    if (!connection)
        throw Error(code, "out of memory");
    const int kind = code & 0xFF;
    if (kind == SQLITE_FULL)
        throw Error(code, "no space is left", ENOSPC);
    const bool askedSystem = kind == SQLITE_CANTOPEN || kind == SQLITE_IOERR;
    throw Error(code, sqlite3_errmsg(connection), askedSystem ? sqlite3_system_errno(connection) : 0);
}

/// The path as a URI with which SQLite takes no locks and looks for no journal.
std::string unchangingUri(const std::filesystem::path& path) {
    std::string uri = "file:";
    for (const char c : path.string()) {
        if (c == '%' || c == '?' || c == '#')
            uri += c == '%' ? "%25" : c == '?' ? "%3f" : "%23";
        else
            uri += c;
    }
    return uri + "?immutable=1";
}

int flagsFor(Access access) {
    switch (access) {
        case Access::Create: return SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE;
        case Access::Write: return SQLITE_OPEN_READWRITE;
        case Access::Read: return SQLITE_OPEN_READONLY;
        case Access::ReadUnchanging: return SQLITE_OPEN_READONLY | SQLITE_OPEN_URI;
    }
    return SQLITE_OPEN_READONLY;
}

std::int64_t sizeOf(const std::filesystem::path& path) {
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    return error ? 0 : static_cast<std::int64_t>(size);
}

int countEffort(void* pointer) {
    Effort& effort = *static_cast<Effort*>(pointer);
    if (++effort.spent <= effort.allowed) return 0;
    const std::int64_t size = sizeOf(effort.file) + sizeOf(effort.file.string() + "-wal");
    effort.allowed = std::max(effort.allowed, (leastAllowed + allowedPerByte * size) / progressEvery);
    return effort.spent > effort.allowed ? 1 : 0;
}

/// Nothing in the schema of a file is executed.
void distrustSchema(sqlite3* handle) {
    for (const int option : {SQLITE_DBCONFIG_TRUSTED_SCHEMA, SQLITE_DBCONFIG_ENABLE_TRIGGER,
                             SQLITE_DBCONFIG_ENABLE_VIEW, SQLITE_DBCONFIG_ENABLE_LOAD_EXTENSION})
        sqlite3_db_config(handle, option, 0, nullptr);
    sqlite3_db_config(handle, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
}

}  // namespace

void Database::Close::operator()(sqlite3* handle) const { sqlite3_close(handle); }

Database::Database(const std::filesystem::path& path, Access access) : effort_(std::make_unique<Effort>()) {
    const std::string name = access == Access::ReadUnchanging ? unchangingUri(path) : path.string();
    sqlite3* handle = nullptr;
    const int code = sqlite3_open_v2(name.c_str(), &handle, flagsFor(access), nullptr);
    handle_.reset(handle);
    if (code != SQLITE_OK)
        fail(code, handle);
    waitForLocks(busyWait);
    distrustSchema(handle);
    addRowChecksum(handle);
    effort_->file = path;
    sqlite3_progress_handler(handle, progressEvery, countEffort, effort_.get());
}

void Database::waitForLocks(std::chrono::milliseconds patience) {
    sqlite3_busy_timeout(handle(), static_cast<int>(patience.count()));
}

void Database::run(const std::string& sql) {
    effort_->spent = 0;
    const int code = sqlite3_exec(handle(), sql.c_str(), nullptr, nullptr, nullptr);
    if (code != SQLITE_OK)
        fail(code, handle());
}

void Statement::Finalize::operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }

Statement::Statement(const Database& database, std::string_view sql) : effort_(database.effort()) {
    effort_.spent = 0;
    sqlite3_stmt* statement = nullptr;
    const int code =
        sqlite3_prepare_v2(database.handle(), sql.data(), static_cast<int>(sql.size()), &statement, nullptr);
    statement_.reset(statement);
    if (code != SQLITE_OK)
        fail(code, database.handle());
}

sqlite3* Statement::connection() const { return sqlite3_db_handle(statement_.get()); }

void Statement::check(int code) const {
    if (code != SQLITE_OK)
        fail(code, connection());
}

Statement& Statement::bind(std::int64_t value) {
    check(sqlite3_bind_int64(statement_.get(), ++bound_, value));
    return *this;
}

Statement& Statement::bind(double value) {
    check(sqlite3_bind_double(statement_.get(), ++bound_, value));
    return *this;
}

Statement& Statement::bind(std::string_view text) {
    check(sqlite3_bind_text(statement_.get(), ++bound_, text.data(), static_cast<int>(text.size()), SQLITE_TRANSIENT));
    return *this;
}

Statement& Statement::bind(std::span<const double> values) {
    if (values.empty()) check(sqlite3_bind_zeroblob(statement_.get(), ++bound_, 0));
    else check(sqlite3_bind_blob64(statement_.get(), ++bound_, values.data(), values.size_bytes(), SQLITE_TRANSIENT));
    return *this;
}

Statement& Statement::bindBytes(std::string_view bytes) {
    check(sqlite3_bind_blob64(statement_.get(), ++bound_, bytes.data(), bytes.size(), SQLITE_TRANSIENT));
    return *this;
}

void Statement::run() {
    effort_.spent = 0;
    next();
    sqlite3_reset(statement_.get());
    bound_ = 0;
}

bool Statement::next() {
    const int code = sqlite3_step(statement_.get());
    if (code == SQLITE_ROW)
        return true;
    if (code != SQLITE_DONE)
        fail(code, connection());
    return false;
}

std::int64_t Statement::integer(int column) const { return sqlite3_column_int64(statement_.get(), column); }

double Statement::real(int column) const {
    return isNull(column) ? std::numeric_limits<double>::quiet_NaN() : sqlite3_column_double(statement_.get(), column);
}

std::string Statement::text(int column) const {
    const auto* bytes = reinterpret_cast<const char*>(sqlite3_column_text(statement_.get(), column));
    return bytes ? std::string(bytes, static_cast<std::size_t>(sqlite3_column_bytes(statement_.get(), column))) : "";
}

std::string Statement::bytes(int column) const {
    const auto* bytes = static_cast<const char*>(sqlite3_column_blob(statement_.get(), column));
    return bytes ? std::string(bytes, static_cast<std::size_t>(sqlite3_column_bytes(statement_.get(), column))) : "";
}

bool Statement::isNull(int column) const { return sqlite3_column_type(statement_.get(), column) == SQLITE_NULL; }

std::int64_t Statement::checksum(int columns) const { return rowChecksum(statement_.get(), columns); }

std::optional<std::vector<double>> Statement::doubles(int column) const {
    const void* bytes = sqlite3_column_blob(statement_.get(), column);
    const std::size_t size = sqlite3_column_bytes(statement_.get(), column);
    if (size % sizeof(double) != 0)
        return std::nullopt;
    std::vector<double> values(size / sizeof(double));
    if (size > 0) std::memcpy(values.data(), bytes, size);
    return values;
}

}  // namespace keyblock::sqlite
