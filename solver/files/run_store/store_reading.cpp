// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/files/run_store/store_reading.h"

#include "solver/files/read_error.h"
#include "solver/files/run_store/frame_payload.h"
#include "solver/files/run_store/run_schema.h"
#include "solver/scene/suggest.h"

#include <sqlite3.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <system_error>
#include <vector>

namespace keyblock::store_reading {

namespace {

namespace fs = std::filesystem;

void requireDatabase(const fs::path& path) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (!fs::exists(status))
        cannotRead(path, "there is no such file; run a scene to create one");
    if (!fs::is_regular_file(status))
        cannotRead(path, "it is not a file; give a run store (.kbrun)");
    std::string start(16, '\0');
    std::ifstream file(path, std::ios::binary);
    if (!file)
        cannotRead(path, "it cannot be opened; check that you may read it");
    file.read(start.data(), static_cast<std::streamsize>(start.size()));
    if (file.gcount() == 0)
        cannotRead(path, "it is empty; run the scene again with --overwrite");
    if (start.compare(0, 15, "SQLite format 3") != 0)
        cannotRead(path, "it is not a run store; give a file that 'keyblock run' wrote");
}

sqlite::Database openedAs(const fs::path& path, sqlite::Access access) {
    sqlite::Database database(path, access);
    database.run("BEGIN; SELECT 1 FROM sqlite_master LIMIT 1");
    return database;
}

/// Opens a store, in most cases read-only. A run that was killed while closing its store leaves a journal that only a
/// writer may roll back. A store left in write-ahead mode in a folder without write permission opens only as immutable.
sqlite::Database openedAsPossible(const fs::path& path) {
    std::error_code ignored;
    const bool alone = !fs::exists(path.string() + "-wal", ignored);
    try {
        return openedAs(path, sqlite::Access::Read);
    } catch (const sqlite::Error& error) {
        if (error.code == SQLITE_READONLY)
            return openedAs(path, sqlite::Access::Write);
        if (error.code == SQLITE_CANTOPEN && alone)
            return openedAs(path, sqlite::Access::ReadUnchanging);
        throw;
    }
}

// In the order of unpacking.
constexpr std::array unpackedPayloads{Payload::Blocks,     Payload::Corners,       Payload::Contacts,
                              Payload::Bolts,      Payload::Nodes,         Payload::Weights,
                              Payload::Inertia,    Payload::ContactForces, Payload::NodeForces, Payload::OtherForces,
                              Payload::BoltExtremes, Payload::BlockExtremes};

/// The definitions of the tables of a run store, as SQLite keeps them.
const std::vector<std::string>& ownTables() {
    static const std::vector<std::string> tables = [] {
        std::vector<std::string> definitions;
        const std::string_view all = run_schema::tables;
        for (std::size_t from = all.find("CREATE"); from != all.npos; from = all.find("CREATE", from))
            definitions.emplace_back(all.substr(from, all.find(';', from) - from)), ++from;
        return definitions;
    }();
    return tables;
}

/// Tables and indexes that SQLite makes itself may be there, too.
void requireOwnTables(const sqlite::Database& database, const fs::path& path) {
    std::size_t own = 0;
    sqlite::Statement rows(database, "SELECT type, name, sql FROM sqlite_master");
    while (rows.next()) {
        const std::string type = rows.text(0), name = rows.text(1);
        const bool isOwn = type == "table" && std::ranges::find(ownTables(), rows.text(2)) != ownTables().end();
        own += isOwn;
        if (!isOwn && !(type == "table" && name.starts_with("sqlite_stat")) && !(type == "index" && rows.isNull(2)))
            cannotRead(path, "it contains the " + type + " " + inQuotes(name) +
                                 ", which is not part of a run store; run the scene again");
    }
    if (own != ownTables().size()) cannotRead(path, damaged);
}

std::int64_t pragma(const sqlite::Database& database, const char* name) {
    sqlite::Statement statement(database, std::string("PRAGMA ") + name);
    return statement.next() ? statement.integer(0) : 0;
}

}  // namespace

void cannotRead(const fs::path& path, const std::string& reason) {
    throw CannotRead("cannot read " + path.string() + ": " + reason);
}

bool lacksJournal(const fs::path& path) {
    constexpr std::size_t readVersionAt = 19;  // in SQLite's file header; 2: write-ahead mode
    std::string start(readVersionAt + 1, '\0');
    std::ifstream file(path, std::ios::binary);
    file.read(start.data(), static_cast<std::streamsize>(start.size()));
    std::error_code ignored;
    const auto journal = fs::file_size(path.string() + "-wal", ignored);
    return file && start[readVersionAt] == 2 && (ignored || journal == 0);
}

void outOfRange() { throw sqlite::Error(SQLITE_CORRUPT, "value out of range"); }

sqlite::Database opened(const fs::path& path) {
    requireDatabase(path);
    return openedAgain(path);
}

sqlite::Database openedAgain(const fs::path& path) {
    try {
        return openedAsPossible(path);
    } catch (const sqlite::Error& error) {
        if (error.code == SQLITE_BUSY)
            cannotRead(path,
                       "another program has it locked; save or discard the changes there, or close it, and try again");
        if (error.code == SQLITE_CORRUPT || error.code == SQLITE_NOTADB)
            cannotRead(path, damaged);
        cannotRead(path, std::string(error.what()) + "; check that you may read it and its folder");
    }
}

void requireRunStore(const sqlite::Database& database, const fs::path& path) {
    if (pragma(database, "application_id") != run_schema::applicationId)
        cannotRead(path, "it is a database but not a run store; give a file that 'keyblock run' wrote");
    if (const std::int64_t version = pragma(database, "user_version"); version != run_schema::version)
        cannotRead(path, "it is a run store of version " + std::to_string(version) + ", this program reads " +
                             std::to_string(run_schema::version) + "; run the scene again");
    requireOwnTables(database, path);
}

std::string selectChecked(const std::string& columns, const std::string& rest, const char* checksum) {
    return "SELECT " + columns + ", " + checksum + " " + rest;
}

bool nextChecked(sqlite::Statement& rows, int columns) {
    if (!rows.next()) return false;
    if (rows.integer(columns) != rows.checksum(columns)) throw sqlite::Error(SQLITE_CORRUPT, "wrong checksum");
    return true;
}

std::string aboutValue(const sqlite::Database& database, std::string_view key) {
    sqlite::Statement statement(database, selectChecked(run_schema::aboutColumns, "FROM about WHERE key=?"));
    statement.bind(key);
    if (!nextChecked(statement, 2)) outOfRange();
    return statement.text(1);
}

int indexBelow(std::int64_t value, std::int64_t first, std::size_t end) {
    if (value < first || value >= static_cast<std::int64_t>(end))
        outOfRange();
    return static_cast<int>(value);
}

FrameHead headAt(const sqlite::Statement& row, const Scene& scene) {
    FrameHead head;
    head.stage = indexBelow(row.integer(1), 0, scene.stages.size());
    head.time = row.real(2);
    head.step = static_cast<long>(row.integer(3));
    head.events = static_cast<long>(row.integer(4));
    Energy& e = head.energy;
    int column = 5;
    for (double* term : {&e.kinetic, &e.strain, &e.contact, &e.bolt, &e.friction, &e.plastic, &e.released, &e.damped,
                         &e.external, &e.balanceError})
        *term = row.real(column++);
    return head;
}

Frame frameAt(const sqlite::Database& database, std::int64_t key, const Scene& scene,
              std::span<const std::size_t> corners, const FrameHead& head) {
    Frame frame{head.stage, head.time, head.step, {}, {}, {}, head.energy, {}, {}, {}, head.events};
    sqlite::Statement statement(
        database, selectChecked(run_schema::payloadColumns, "FROM frames WHERE frame=?", "payload_checksum"));
    statement.bind(key);
    if (!nextChecked(statement, payloadWidth)) outOfRange();
    for (const Payload payload : unpackedPayloads)
        if (!unpack(payload, known(statement.doubles(static_cast<int>(payload))), scene, corners, frame))
            outOfRange();
    return frame;
}

}  // namespace keyblock::store_reading
