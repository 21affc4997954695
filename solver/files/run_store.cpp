// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One read transaction spans the life of the reader, so that events, history and
// frames belong together however fast the run goes on. What comes out of the file
// is checked before it is used as an index.
#include "solver/files/run_store.h"

#include "solver/files/errors.h"
#include "solver/files/frame_payload.h"
#include "solver/files/run_schema.h"
#include "solver/files/scene_file.h"
#include "solver/results/history.h"
#include "solver/results/words.h"
#include "solver/scene/solved_blocks.h"

#include <sqlite3.h>

#include <fstream>
#include <system_error>

namespace keyblock {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void cannotRead(const fs::path& path, const std::string& reason) {
    throw CannotRead("cannot read " + path.string() + ": " + reason);
}

constexpr const char* damaged = "the store is damaged; run the scene again with --overwrite";

void requireDatabase(const fs::path& path) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (!fs::exists(status))
        cannotRead(path, "there is no such file; run a scene to make one");
    if (!fs::is_regular_file(status))
        cannotRead(path, "it is no file; give a run store (.kbrun)");
    std::string start(16, '\0');
    std::ifstream file(path, std::ios::binary);
    if (!file)
        cannotRead(path, "it cannot be opened; check the right to read it");
    file.read(start.data(), static_cast<std::streamsize>(start.size()));
    if (file.gcount() == 0)
        cannotRead(path, "it is empty; run the scene again with --overwrite");
    if (start.compare(0, 15, "SQLite format 3") != 0)
        cannotRead(path, "it is no run store; give a file that 'keyblock run' wrote");
}

sqlite::Database openedAs(const fs::path& path, sqlite::Access access) {
    sqlite::Database database(path, access);
    database.run("BEGIN; SELECT count(*) FROM sqlite_master");
    return database;
}

/// Reading alone does in most cases. A run killed while it closed its store leaves a journal that only a writer may
/// roll back; a store left in write-ahead mode in a folder without the right to write opens only as unchanging.
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

sqlite::Database opened(const fs::path& path) {
    requireDatabase(path);
    try {
        return openedAsPossible(path);
    } catch (const sqlite::Error& error) {
        if (error.code == SQLITE_BUSY)
            cannotRead(path, "another program holds it; try again");
        if (error.code == SQLITE_CORRUPT || error.code == SQLITE_NOTADB)
            cannotRead(path, damaged);
        cannotRead(path, std::string(error.what()) + "; check the right to read it and its folder");
    }
}

std::int64_t pragma(const sqlite::Database& database, const char* name) {
    sqlite::Statement statement(database, std::string("PRAGMA ") + name);
    return statement.next() ? statement.integer(0) : 0;
}

std::string aboutValue(const sqlite::Database& database, std::string_view key) {
    sqlite::Statement statement(database, "SELECT value FROM about WHERE key=?");
    statement.bind(key);
    return statement.next() ? statement.text(0) : "";
}

/// The stored index; throws `sqlite::Error` when it leads nowhere.
int indexBelow(std::int64_t value, std::int64_t first, std::size_t end) {
    if (value < first || value >= static_cast<std::int64_t>(end))
        throw sqlite::Error(SQLITE_CORRUPT, "index out of range");
    return static_cast<int>(value);
}

/// The same for one that was stored as a double.
int indexBelow(double value, std::size_t end) {
    if (!(value >= 0.0 && value < static_cast<double>(end)))
        throw sqlite::Error(SQLITE_CORRUPT, "index out of range");
    return static_cast<int>(value);
}

template <typename Value>
Value known(const std::optional<Value>& value) {
    if (!value)
        throw sqlite::Error(SQLITE_CORRUPT, "value out of range");
    return *value;
}

constexpr std::size_t anyNumber = 1000000000;

Event eventAt(const sqlite::Statement& row, const Scene& scene, std::size_t blocks) {
    Event event;
    event.stage = indexBelow(row.integer(0), 0, scene.stages.size());
    event.time = row.real(1);
    event.step = static_cast<long>(row.integer(2));
    event.kind = known(eventKindOf(row.text(3)));
    event.bolt = indexBelow(row.integer(4), -1, scene.bolts.size());
    event.node = indexBelow(row.integer(5), -1, anyNumber);
    event.element = indexBelow(row.integer(6), -1, anyNumber);
    event.block = indexBelow(row.integer(7), -1, blocks);
    event.otherBlock = indexBelow(row.integer(8), -1, blocks);
    event.position = {row.real(9), row.real(10)};
    event.axialForce = row.real(11);
    event.shearForce = row.real(12);
    event.anchorForce = row.real(13);
    event.slip = row.real(14);
    event.historyRow = indexBelow(row.integer(15), -1, anyNumber);
    event.cause = indexBelow(row.integer(16), -1, anyNumber);
    return event;
}

StageRecord stageAt(const sqlite::Statement& row, const Scene& scene, std::size_t blocks) {
    StageRecord record;
    record.result.stage = indexBelow(row.integer(0), 0, scene.stages.size());
    record.ended = !row.isNull(1);
    if (!record.ended)
        return record;
    StageResult& result = record.result;
    result.outcome = known(outcomeOf(row.text(1)));
    result.time = row.real(2);
    result.steps = static_cast<long>(row.integer(3));
    result.message = row.text(4);
    for (const double block : known(row.doubles(5)))
        result.blocks.push_back(indexBelow(block, blocks));
    result.health.steps = static_cast<long>(row.integer(12));
    result.health.passes = static_cast<long>(row.integer(6));
    result.health.stepCuts = static_cast<long>(row.integer(7));
    result.health.factorizations = static_cast<long>(row.integer(8));
    result.health.maxPenetrationRatio = row.real(9);
    result.health.maxResidual = row.real(10);
    result.health.balanceError = row.real(11);
    return record;
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
    return head;
}

}  // namespace

/// Does `work`, and tells what SQLite finds wrong as a file that cannot be read.
template <typename Work>
auto RunStore::guarded(Work work) const {
    try {
        return work();
    } catch (const sqlite::Error&) {
        cannotRead(path_, damaged);
    }
}

RunStore::RunStore(const fs::path& path) : path_(path), database_(opened(path)) {
    guarded([&] {
        if (pragma(database_, "application_id") != run_schema::applicationId)
            cannotRead(path_, "it is a database, but no run store; give a file that 'keyblock run' wrote");
        if (const std::int64_t version = pragma(database_, "user_version"); version != run_schema::version)
            cannotRead(path_, "it is a run store of version " + std::to_string(version) + ", this program reads " +
                                  std::to_string(run_schema::version) + "; run the scene again");
        readAbout();
        readColumns();
        readHeads();
    });
}

void RunStore::readAbout() {
    sceneHash_ = aboutValue(database_, "scene_hash");
    programVersion_ = aboutValue(database_, "program_version");
    SceneReading reading = readSceneText(aboutValue(database_, "scene"), path_.string() + " (scene)");
    if (!reading.scene) {
        const std::string first = reading.problems.empty() ? "" : " (" + oneLine(reading.problems.front()) + ")";
        cannotRead(path_, "this program does not accept the scene in it" + first + "; run the scene again");
    }
    scene_ = std::move(reading.cut ? reading.cut->scene : *reading.scene);
    names_ = keyblock::blockNames(scene_);
}

void RunStore::readColumns() {
    sqlite::Statement statement(database_, "SELECT name FROM columns WHERE payload='history' ORDER BY position");
    while (statement.next())
        columns_.names.push_back(statement.text(0));
    columns_.monitorValues = historyColumns(scene_).monitorValues;
    if (columns_ != historyColumns(scene_))
        cannotRead(path_, damaged);
}

void RunStore::readHeads() {
    sqlite::Statement statement(database_,
                                "SELECT stage, time, step, kinetic, strain, contact, bolt, friction, plastic, "
                                "released, damped, external, balance_error, frame FROM frames ORDER BY frame");
    while (statement.next()) {
        heads_.push_back(headAt(statement, scene_));
        frameKeys_.push_back(statement.integer(13));
    }
}

std::vector<StageRecord> RunStore::stages() const {
    return guarded([&] {
        std::vector<StageRecord> records;
        sqlite::Statement statement(database_,
                                    "SELECT stage, outcome, time, steps, message, blocks, passes, step_cuts, "
                                    "factorizations, max_penetration_ratio, max_residual, balance_error, health_steps "
                                    "FROM stages ORDER BY stage");
        while (statement.next())
            records.push_back(stageAt(statement, scene_, names_.size()));
        return records;
    });
}

std::vector<Event> RunStore::events() const {
    return guarded([&] {
        std::vector<Event> events;
        sqlite::Statement statement(database_,
                                    "SELECT stage, time, step, kind, bolt, node, element, block, other_block, x, y, "
                                    "axial_force, shear_force, anchor_force, slip, history_row, cause FROM events "
                                    "ORDER BY event");
        while (statement.next())
            events.push_back(eventAt(statement, scene_, names_.size()));
        return events;
    });
}

std::vector<HistoryRow> RunStore::history() const {
    return guarded([&] {
        std::vector<HistoryRow> rows;
        sqlite::Statement statement(database_, "SELECT stage, time, step, \"values\" FROM history ORDER BY row");
        while (statement.next()) {
            HistoryRow row;
            row.stage = indexBelow(statement.integer(0), 0, scene_.stages.size());
            row.time = statement.real(1);
            row.step = static_cast<long>(statement.integer(2));
            row.values = known(statement.doubles(3));
            if (row.values.size() != columns_.names.size())
                cannotRead(path_, damaged);
            rows.push_back(std::move(row));
        }
        return rows;
    });
}

Frame RunStore::frame(std::size_t index) const {
    return guarded([&] {
        const FrameHead& head = heads_.at(index);
        Frame frame{head.stage, head.time, head.step, {}, {}, {}, head.energy};
        sqlite::Statement statement(database_,
                                    "SELECT blocks, corners, contacts, nodes, bolts FROM frames WHERE frame=?");
        statement.bind(frameKeys_.at(index));
        if (!statement.next())
            cannotRead(path_, damaged);
        for (const Payload payload :
             {Payload::Blocks, Payload::Corners, Payload::Contacts, Payload::Bolts, Payload::Nodes})
            if (!unpack(payload, known(statement.doubles(static_cast<int>(payload))), scene_, names_.size(), frame))
                cannotRead(path_, damaged);
        return frame;
    });
}

std::optional<StoredCheckpoint> RunStore::checkpoint() const {
    return guarded([&]() -> std::optional<StoredCheckpoint> {
        sqlite::Statement statement(database_, "SELECT build, hash, state FROM checkpoint");
        if (!statement.next())
            return std::nullopt;
        return StoredCheckpoint{statement.text(0), statement.text(1), statement.bytes(2)};
    });
}

Results readResults(const RunStore& store) {
    Results results;
    results.columns = store.columns();
    results.history = store.history();
    results.events = store.events();
    for (std::size_t index = 0; index < store.frames().size(); ++index)
        results.frames.push_back(store.frame(index));
    for (const StageRecord& record : store.stages())
        if (record.ended)
            results.stages.push_back(record.result);
    return results;
}

}  // namespace keyblock
