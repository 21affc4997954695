// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The store is first created in full under another name, with schema and scene but
// without a write-ahead file. It is then moved to its path in one operation and only
// then opened for the run, so that a store without its scene is never visible.
#include "solver/files/run_store/run_store_writer.h"

#include "solver/engine/step/blas_kernel.h"
#include "solver/files/run_store/checkpoint_bytes.h"
#include "solver/files/run_store/frame_payload.h"
#include "solver/files/program_version.h"
#include "solver/files/run_store/run_schema.h"
#include "solver/files/scene/scene_file.h"
#include "solver/files/sha256.h"
#include "solver/files/run_store/sqlite.h"
#include "solver/files/run_store/store_lock.h"
#include "solver/files/run_store/store_reading.h"
#include "solver/files/atomic_file.h"
#include "solver/results/run_source.h"
#include "solver/results/result_names.h"
#include "solver/scene/collapse_stage.h"

#include <sqlite3.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <fstream>
#include <system_error>
#include <utility>

namespace keyblock {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void cannotWrite(const fs::path& path, const sqlite::Error& error) {
    if ((error.code & 0xFF) == SQLITE_BUSY)
        throw CannotWrite("cannot write " + path.string() +
                          ": another program keeps it locked; save or discard the "
                          "changes there and close it, then run again with --resume");
    throw CannotWrite(cannotWriteText(path, error.systemError, error.what()));
}

[[noreturn]] void refuseExisting(const fs::path& path) {
    throw StoreExists(path.string() + " exists; add --resume to continue it or --overwrite to replace it, or choose "
                                      "another --out");
}

bool startsAsDatabase(const fs::path& path) {
    std::string start(16, '\0');
    std::ifstream file(path, std::ios::binary);
    file.read(start.data(), static_cast<std::streamsize>(start.size()));
    return file && start.compare(0, 15, "SQLite format 3") == 0;
}

bool isRunStore(const fs::path& path) {
    if (!startsAsDatabase(path))
        return false;
    try {
        const sqlite::Database database(path, sqlite::Access::Write);
        sqlite::Statement id(database, "PRAGMA application_id");
        return id.next() && id.integer(0) == run_schema::applicationId;
    } catch (const sqlite::Error& error) {
        // The file is too damaged to be opened, but only a database starts like this.
        return error.code == SQLITE_CORRUPT || error.code == SQLITE_NOTADB;
    }
}

/// Merges the write-ahead file of the old store into it, so that it is never mistaken for that of the new store. If
/// only this file or a journal remains, because the store of a killed run was removed, it is deleted for the same
/// reason.
void settleOldStore(const fs::path& path) {
    std::error_code ignored;
    try {
        if (fs::exists(path, ignored))
            sqlite::Database(path, sqlite::Access::Write).run("PRAGMA journal_mode=DELETE");
    } catch (const sqlite::Error& error) {
        if (error.code == SQLITE_BUSY || error.code == SQLITE_LOCKED)
            throw CannotWrite("cannot replace " + path.string() +
                              ": another program has it open; wait for it, or choose another --out");
    }
    for (const char* ending : {"-wal", "-shm", "-journal"})
        fs::remove(path.string() + ending, ignored);
}

/// The parameters `?first, …, ?last` of a statement.
std::string numbered(int first, int last) {
    std::string text = "?" + std::to_string(first);
    for (int number = first + 1; number <= last; ++number) text += ", ?" + std::to_string(number);
    return text;
}

/// Inserts a row with its checksum. \param columns a list of run_schema.h, of which the first `width` are bound.
std::string insertChecked(const std::string& table, const std::string& columns, int width) {
    std::size_t end = 0;
    for (int column = 0; column < width; ++column) end = columns.find(',', end + 1);
    const std::string values = numbered(1, width);
    return "INSERT OR REPLACE INTO " + table + " (" + columns.substr(0, end) + ", checksum) VALUES (" + values +
           ", row_checksum(" + values + "))";
}

void writeColumns(const sqlite::Database& database, const HistoryColumns& history) {
    sqlite::Statement insert(database, "INSERT INTO columns VALUES (?,?,?,?,?)");
    for (std::size_t payload = 0; payload < payloadWords().size(); ++payload) {
        std::int64_t position = 0;
        for (const PayloadColumn& column : payloadColumns(static_cast<Payload>(payload)))
            insert.bind(payloadWords()[payload]).bind(position++).bind(column.name).bind(column.unit)
                .bind(column.meaning).run();
    }
    std::int64_t position = 0;
    for (const std::string& name : history.names) {
        const bool monitor = position < history.monitorValues;
        insert.bind("history").bind(position++).bind(name).bind("SI");
        insert.bind(monitor ? "value of a monitor" : "largest value along the bolt, with its sign").run();
    }
    insert.bind("mechanism").bind(std::int64_t{0}).bind("block").bind("")
        .bind("index of a block that moves or is not in equilibrium").run();
    position = 0;
    for (const auto& [name, unit, meaning] :
         {std::array{"block", "", "index of an unstable block"},
          std::array{"mode", "", "0 slides, 1 falls, 2 topples, 3 follows others"},
          std::array{"moved", "m", "displacement of the corner that moved farthest, relative to what it touched at the "
                                   "start of the stage"},
          std::array{"weight", "N", "for the whole thickness"}})
        insert.bind("unstable").bind(position++).bind(name).bind(unit).bind(meaning).run();
}

void writeAbout(const sqlite::Database& database, const Scene& scene, const HistoryColumns& history) {
    const std::string text = wholeSceneText(scene);
    sqlite::Statement insert(database, insertChecked("about", run_schema::aboutColumns, 2));
    const auto put = [&](std::string_view key, std::string_view value) { insert.bind(key).bind(value).run(); };
    put("format", "keyblock-run");
    put("program_version", programVersion());
    put("blas_kernel", blasKernel());
    put("layout", run_schema::layout);
    put("scene", text);
    put("scene_hash", sha256(text));
    put("monitor_values", std::to_string(history.monitorValues));
}

/// Checks the folder first, because SQLite does not report what is wrong with one.
void requireWritableFolder(const fs::path& path) {
    const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    if (::access(folder.c_str(), W_OK | X_OK) != 0)
        throw CannotWrite(cannotWriteText(path, errno));
}

/// Makes a complete store without results of the empty file `part`.
void makeStore(const fs::path& part, const Scene& scene, const HistoryColumns& columns) {
    sqlite::Database database(part, sqlite::Access::Write);
    database.run("PRAGMA journal_mode=MEMORY; PRAGMA application_id=" + std::to_string(run_schema::applicationId) +
                 "; PRAGMA user_version=" + std::to_string(run_schema::version) + "; BEGIN;");
    database.run(run_schema::tables);
    writeColumns(database, columns);
    writeAbout(database, scene, columns);
    database.run("COMMIT; PRAGMA journal_mode=WAL");
}

/// A path next to `path` at which there is no file: `path` itself, or its name with a number.
fs::path freePath(const fs::path& path) {
    std::error_code ignored;
    fs::path free = path;
    for (int number = 2; fs::exists(fs::symlink_status(free, ignored)); ++number)
        free.replace_filename(path.stem().string() + "-" + std::to_string(number) + path.extension().string());
    return free;
}

/// Merges the write-ahead file into the database. \return false if a reader prevented it.
bool mergesJournal(const sqlite::Database& database) {
    sqlite::Statement merge(database, "PRAGMA wal_checkpoint(TRUNCATE)");
    return merge.next() && merge.integer(0) == 0;
}

/// Removes what is left of a write-ahead file that was merged and whose database is no longer at `path`.
void removeEmptyJournal(const fs::path& path) {
    std::error_code ignored;
    if (fs::exists(path, ignored) || fs::file_size(path.string() + "-wal", ignored) != 0) return;
    for (const char* ending : {"-wal", "-shm"}) fs::remove(path.string() + ending, ignored);
}

/// Moves the new store to its path; a store that another run has created there in the meantime is kept.
void putInPlace(const fs::path& part, const fs::path& path, bool overwrite) {
    std::error_code error;
    if (!overwrite) {
        fs::create_hard_link(part, path, error);
        if (error == std::errc::file_exists)
            refuseExisting(path);
        if (!error)
            return;  // the temporary name is removed with the part
    }
    fs::rename(part, path, error);
    if (error)
        throw CannotWrite(cannotWriteText(path, error.value()));
}

constexpr int stageBeginWidth = 3;  // a stage that has begun has only the first columns
constexpr const char* putCheckpoint = "INSERT OR REPLACE INTO checkpoint VALUES (1,?,?,?)";

/// A frame's numbers and their checksum, then its BLOBs and theirs.
std::string insertFrame() {
    using namespace store_reading;
    const std::string numbers = numbered(1, headWidth), blobs = numbered(headWidth + 1, headWidth + payloadWidth);
    return std::string("INSERT INTO frames (") + run_schema::headColumns + ", checksum, payload_checksum, " +
           run_schema::payloadColumns + ") VALUES (" + numbers + ", row_checksum(" + numbers + "), row_checksum(" +
           blobs + "), " + blobs + ")";
}

/// A row of four values per block, as listed in table `columns`.
std::vector<double> numbersOf(const std::vector<UnstableBlock>& blocks) {
    std::vector<double> numbers;
    for (const UnstableBlock& one : blocks)
        numbers.insert(numbers.end(),
                       {static_cast<double>(one.block), static_cast<double>(one.mode), one.moved, one.weight});
    return numbers;
}

/// Deletes the results of a run after a checkpoint. Frames and events are numbered from 1, history rows from 0.
void forgetWhatFollows(sqlite::Database& database, const Checkpoint& from) {
    const auto clear = [&](const char* sql, long kept) {
        sqlite::Statement(database, sql).bind(std::int64_t{kept}).run();
    };
    clear("DELETE FROM events WHERE event>?", from.written.events);
    clear("DELETE FROM history WHERE row>=?", from.written.historyRows);
    clear("DELETE FROM frames WHERE frame>?", from.written.frames);
    clear("DELETE FROM stages WHERE stage>=?", from.stage);
}

}  // namespace

/// The store while it is open. Statements are destroyed before the connection to which they belong.
struct RunStoreWriter::Open {
    Open(const fs::path& path, std::chrono::milliseconds patience) : lock(path), database(path, sqlite::Access::Write) {
        database.waitForLocks(patience);
        database.run("PRAGMA journal_mode=WAL; PRAGMA synchronous=NORMAL");
    }

    void beginIfNeeded() {
        if (!inTransaction)
            database.run("BEGIN");
        inTransaction = true;
    }

    void commit() {
        if (inTransaction)
            database.run("COMMIT");
        inTransaction = false;
    }

    StoreLock lock;
    sqlite::Database database;
    bool inTransaction = false;
    Written written;
    sqlite::Statement stage{database, insertChecked("stages", run_schema::stageColumns, stageBeginWidth)};
    sqlite::Statement stageEnd{database, insertChecked("stages", run_schema::stageColumns, store_reading::stageWidth)};
    sqlite::Statement event{database, insertChecked("events", run_schema::eventColumns, store_reading::eventWidth)};
    sqlite::Statement history{database,
                              insertChecked("history", run_schema::historyColumns, store_reading::historyWidth)};
    sqlite::Statement frame{database, insertFrame()};
    sqlite::Statement checkpoint{database, putCheckpoint};
};

void requireFreeStore(const fs::path& path, bool overwrite) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (!fs::exists(status))
        return;
    if (!overwrite)
        refuseExisting(path);
    const bool empty = fs::is_regular_file(status) && fs::file_size(path, error) == 0;
    if (!empty && (!fs::is_regular_file(status) || !isRunStore(path)))
        throw StoreExists(path.string() + " is not a run store and is not overwritten; choose another --out");
}

RunStoreWriter::RunStoreWriter(fs::path path, bool overwrite, std::chrono::milliseconds patience)
    : path_(std::move(path)), overwrite_(overwrite), patience_(patience) {
    requireFreeStore(path_, overwrite_);
}

RunStoreWriter::~RunStoreWriter() {
    try {
        close();
    } catch (const CannotWrite&) {
        // The store keeps what was committed; there is no caller left to receive the error.
    }
}

/// Executes `work` on the open store inside a transaction; after a failure, uncommitted changes are rolled back.
template <typename Work>
void RunStoreWriter::write(Work work) {
    if (!open_)
        throw CannotWrite("cannot write " + path_.string() + ": the store is closed; run the scene again");
    try {
        open_->beginIfNeeded();
        work(*open_);
    } catch (const sqlite::Error& error) {
        open_.reset();
        cannotWrite(path_, error);
    }
    if (!open_->inTransaction && !open_->lock.isAt(path_)) leaveLostStore();
}

/// Ends the writing of a store that is no longer at its path. A store that was moved receives all results; one that was
/// deleted is written to its path again, from the file that this process still has open.
void RunStoreWriter::leaveLostStore() {
    const std::string lost = "cannot write " + path_.string() + ": it was deleted, moved or replaced during the run; ";
    const fs::path part = partPath(path_);
    fs::path kept;
    try {
        if (mergesJournal(open_->database)) kept = open_->lock.presentPath();
        if (kept.empty()) {
            makePartFile(path_);
            sqlite::Statement(open_->database, "VACUUM INTO ?").bind(part.string()).run();
        }
        open_.reset();
        removeEmptyJournal(path_);
        if (kept.empty()) {
            kept = freePath(path_);
            fs::rename(part, kept);
        }
    } catch (const std::exception& error) {
        open_.reset();
        throw CannotWrite(lost + "its results could not be kept (" + error.what() + "); run the scene again");
    }
    throw CannotWrite(lost + "the results so far are in " + kept.string() + "; run again with --resume --out " +
                      kept.string());
}

void RunStoreWriter::begin(const Scene& scene, const HistoryColumns& columns) {
    scene_ = withCollapseStages(scene);
    requireFreeStore(path_, overwrite_);
    requireWritableFolder(path_);
    const fs::path part = makePartFile(path_);
    std::error_code ignored;
    try {
        makeStore(part, scene, columns);
        settleOldStore(path_);
        putInPlace(part, path_, overwrite_);
        fs::remove(part, ignored);
        open_ = std::make_unique<Open>(path_, patience_);
    } catch (const sqlite::Error& error) {
        fs::remove(part, ignored);
        cannotWrite(path_, error);
    } catch (const CannotWrite&) {
        fs::remove(part, ignored);
        throw;
    }
}

void RunStoreWriter::resume(const Scene& scene, const HistoryColumns&, const Checkpoint& from) {
    scene_ = withCollapseStages(scene);
    try {
        open_ = std::make_unique<Open>(path_, patience_);
    } catch (const sqlite::Error& error) {
        cannotWrite(path_, error);
    }
    write([&](Open& open) {
        forgetWhatFollows(open.database, from);
        if (from.begun) putStage(open, from.stage);
        open.written = from.written;
        open.commit();
    });
}

void RunStoreWriter::putStage(Open& open, int stage) const {
    open.stage.bind(std::int64_t{stage}).bind(stageName(scene_, stage));
    open.stage.bind(wordOf(scene_.stages.at(static_cast<std::size_t>(stage)).kind)).run();
}

void RunStoreWriter::stageBegins(int stage) {
    write([&](Open& open) {
        putStage(open, stage);
        open.commit();
    });
}

void RunStoreWriter::event(const Event& e) {
    write([&](Open& open) {
        open.event.bind(std::int64_t{++open.written.events});
        open.event.bind(std::int64_t{e.stage}).bind(e.time).bind(std::int64_t{e.step}).bind(wordOf(e.kind));
        for (const int index : {e.bolt, e.node, e.element, e.block, e.otherBlock})
            open.event.bind(std::int64_t{index});
        for (const double value : {e.position.x(), e.position.y(), e.axialForce, e.shearForce, e.anchorForce, e.slip})
            open.event.bind(value);
        open.event.bind(std::int64_t{open.written.historyRows - 1}).bind(std::int64_t{e.cause}).run();
    });
}

void RunStoreWriter::history(const HistoryRow& row) {
    write([&](Open& open) {
        open.history.bind(std::int64_t{open.written.historyRows++})
            .bind(std::int64_t{row.stage})
            .bind(row.time)
            .bind(std::int64_t{row.step});
        open.history.bind(std::span<const double>(row.values)).run();
    });
}

void RunStoreWriter::frame(const Frame& frame) {
    write([&](Open& open) {
        const Energy& e = frame.energy;
        open.frame.bind(std::int64_t{++open.written.frames});
        open.frame.bind(std::int64_t{frame.stage}).bind(frame.time).bind(std::int64_t{frame.step});
        open.frame.bind(std::int64_t{frame.events});
        for (const double value : {e.kinetic, e.strain, e.contact, e.bolt, e.friction, e.plastic, e.released, e.damped,
                                   e.external, e.balanceError})
            open.frame.bind(value);
        for (std::size_t payload = 0; payload < payloadWords().size(); ++payload)
            open.frame.bind(std::span<const double>(pack(static_cast<Payload>(payload), frame)));
        open.frame.run();
        open.commit();
    });
}

void RunStoreWriter::stageEnds(const StageResult& result) {
    write([&](Open& open) {
        const std::vector<double> blocks(result.blocks.begin(), result.blocks.end());
        const Health& health = result.health;
        open.stageEnd.bind(std::int64_t{result.stage}).bind(stageName(scene_, result.stage));
        open.stageEnd.bind(wordOf(scene_.stages.at(static_cast<std::size_t>(result.stage)).kind));
        open.stageEnd.bind(wordOf(result.outcome)).bind(result.time).bind(std::int64_t{result.steps});
        open.stageEnd.bind(result.message).bind(std::span<const double>(blocks));
        open.stageEnd.bind(std::int64_t{health.passes}).bind(std::int64_t{health.stepCuts});
        open.stageEnd.bind(std::int64_t{health.energyCuts});
        const StepWork& work = health.work;
        for (const long count : {work.factorizations, work.fullFactorizations, work.ranks, work.solves, work.products,
                                 work.sweeps})
            open.stageEnd.bind(std::int64_t{count});
        open.stageEnd.bind(health.maxPenetrationRatio).bind(health.maxResidual).bind(health.balanceError);
        open.stageEnd.bind(std::int64_t{health.steps});
        const std::vector<double> unstable = numbersOf(result.unstable);
        const std::vector<double> farthest =
            result.farthest.block < 0 ? std::vector<double>{} : numbersOf({result.farthest});
        const std::vector<double> loose(result.loose.begin(), result.loose.end());
        for (const std::vector<double>* numbers : {&unstable, &farthest, &loose})
            open.stageEnd.bind(std::span<const double>(*numbers));
        open.stageEnd.bind(std::int64_t{health.worst.block}).bind(health.worst.share).bind(health.worst.force);
        open.stageEnd.bind(std::int64_t{health.awake}).bind(std::int64_t{health.movable});
        for (const long count : {open.written.events, open.written.historyRows, open.written.frames})
            open.stageEnd.bind(std::int64_t{count});
        open.stageEnd.run();
        if (endsRun(scene_, result))
            open.database.run("DELETE FROM checkpoint");
        open.commit();
    });
}

void RunStoreWriter::checkpoint(const Checkpoint& checkpoint) {
    write([&](Open& open) {
        const std::string bytes = bytesOf(checkpoint);
        open.checkpoint.bind(buildName()).bind(sha256(bytes)).bindBytes(bytes).run();
        open.commit();
    });
}

void RunStoreWriter::close() {
    if (!open_)
        return;
    try {
        open_->commit();
        open_.reset();
    } catch (const sqlite::Error& error) {
        open_.reset();
        cannotWrite(path_, error);
    }
    try {
        sqlite::Database(path_, sqlite::Access::Write).run("PRAGMA journal_mode=DELETE");
    } catch (const sqlite::Error&) {
        // Another program is reading the store: it remains in write-ahead mode, which is harmless.
    }
}

}  // namespace keyblock
