// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/files/run_store/store_reading.h"

#include "solver/files/read_error.h"
#include "solver/files/run_store/frame_payload.h"
#include "solver/files/run_store/run_schema.h"

#include <sqlite3.h>

#include <array>
#include <fstream>
#include <system_error>

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
    database.run("BEGIN; SELECT count(*) FROM sqlite_master");
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

std::int64_t pragma(const sqlite::Database& database, const char* name) {
    sqlite::Statement statement(database, std::string("PRAGMA ") + name);
    return statement.next() ? statement.integer(0) : 0;
}

}  // namespace

void cannotRead(const fs::path& path, const std::string& reason) {
    throw CannotRead("cannot read " + path.string() + ": " + reason);
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
            cannotRead(path, "another program is using it; try again");
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
}

std::string aboutValue(const sqlite::Database& database, std::string_view key) {
    sqlite::Statement statement(database, "SELECT value FROM about WHERE key=?");
    statement.bind(key);
    return statement.next() ? statement.text(0) : "";
}

int indexBelow(std::int64_t value, std::int64_t first, std::size_t end) {
    if (value < first || value >= static_cast<std::int64_t>(end))
        outOfRange();
    return static_cast<int>(value);
}

FrameHead headAt(const sqlite::Statement& row, const Scene& scene) {
    FrameHead head;
    head.stage = indexBelow(row.integer(0), 0, scene.stages.size());
    head.time = row.real(1);
    head.step = static_cast<long>(row.integer(2));
    Energy& e = head.energy;
    int column = 3;
    for (double* term : {&e.kinetic, &e.strain, &e.contact, &e.bolt, &e.friction, &e.plastic, &e.released, &e.damped,
                         &e.external, &e.balanceError})
        *term = row.real(column++);
    head.events = static_cast<long>(row.integer(column));
    return head;
}

Frame frameAt(const sqlite::Database& database, std::int64_t key, const Scene& scene,
              std::span<const std::size_t> corners, const FrameHead& head) {
    Frame frame{head.stage, head.time, head.step, {}, {}, {}, head.energy, {}, {}, {}, head.events};
    sqlite::Statement statement(database, "SELECT blocks, corners, contacts, nodes, bolts, weights, inertia, "
                                          "contact_forces, node_forces, other_forces, bolt_extremes, block_extremes "
                                          "FROM frames WHERE frame=?");
    statement.bind(key);
    if (!statement.next())
        outOfRange();
    for (const Payload payload : unpackedPayloads)
        if (!unpack(payload, known(statement.doubles(static_cast<int>(payload))), scene, corners, frame))
            outOfRange();
    return frame;
}

}  // namespace keyblock::store_reading
