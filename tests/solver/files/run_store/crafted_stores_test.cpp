// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A database in which SQLite would execute what its author wrote is no run store: views,
// triggers, virtual tables, computed columns and indexes are refused, and a statement
// over a damaged file ends.
#include "solver/files/read_error.h"
#include "solver/files/run_store/resumption.h"
#include "solver/files/run_store/run_store.h"
#include "solver/files/run_store/run_store_writer.h"
#include "solver/files/run_store/run_summary.h"
#include "solver/files/run_store/stored_frames.h"
#include "solver/files/run_store/stored_scene.h"
#include "tests/scratch_folder.h"
#include "tests/solver/results/sample_run.h"

#include <gtest/gtest.h>
#include <sqlite3.h>

#include <chrono>

namespace keyblock {
namespace {

namespace fs = std::filesystem;

const std::string endless = "WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n) ";

/// A view with the rows of the recursion in place of a table.
std::string endlessView(const std::string& table, const std::string& columns) {
    return "DROP TABLE " + table + "; CREATE VIEW " + table + "(" + columns + ") AS " + endless + "SELECT i" + [&] {
        std::string more;
        for (const char c : columns)
            if (c == ',') more += ", i";
        return more;
    }() + " FROM n";
}

/// Recreates the table with its rows and replaces `from` in its definition with `to`.
std::string redefined(const std::string& table, const std::string& from, const std::string& to) {
    return "PRAGMA writable_schema=ON; UPDATE sqlite_master SET sql = replace(sql, '" + from + "', '" + to +
           "') WHERE name = '" + table + "'; PRAGMA writable_schema=RESET";
}

struct CraftedStore {
    std::string name, sql;
    bool isRead = false;  // false: must be refused
};

const std::vector<CraftedStore>& craftedStores() {
    const std::string aboutRows = "INSERT INTO about SELECT * FROM kept; DROP TABLE kept";
    static const std::vector<CraftedStore> stores{
        {"view_frames", endlessView("frames", "frame, stage, time, step, events, checksum, payload_checksum")},
        {"view_events", endlessView("events", "event, stage, time, step, kind, checksum")},
        {"view_history", endlessView("history", "row, stage, time, step, \"values\", checksum")},
        {"view_stages", endlessView("stages", "stage, name, kind, outcome, checksum")},
        {"view_about", endlessView("about", "key, value, checksum")},
        {"view_columns", endlessView("columns", "payload, position, name, unit, meaning")},
        {"view_checkpoint", endlessView("checkpoint", "key, build, hash, state")},
        {"view_more", "CREATE VIEW more AS SELECT * FROM frames"},
        {"trigger_endless", "CREATE TRIGGER t BEFORE DELETE ON events BEGIN INSERT INTO events(stage) " + endless +
                                "SELECT i FROM n; END"},
        {"trigger_rewrites", "CREATE TRIGGER t AFTER DELETE ON frames BEGIN UPDATE about SET value = 'x'; END"},
        {"trigger_insert", "CREATE TRIGGER t AFTER INSERT ON frames BEGIN DELETE FROM frames; END"},
        {"trigger_of_view",
         "CREATE VIEW v AS SELECT 1 AS a; CREATE TRIGGER t INSTEAD OF INSERT ON v BEGIN "
         "DELETE FROM frames; END"},
        {"generated_column", "ALTER TABLE frames ADD COLUMN more REAL AS (hex(zeroblob(1000000000)))"},
        {"generated_checksum", redefined("history", "checksum INTEGER", "checksum INTEGER AS (row)")},
        {"stored_column", redefined("events", "x REAL", "x REAL AS (y) STORED")},
        {"without_rowid",
         "CREATE TABLE kept AS SELECT * FROM about; DROP TABLE about; CREATE TABLE about (key TEXT "
         "PRIMARY KEY, value TEXT NOT NULL, checksum INTEGER) WITHOUT ROWID; " +
             aboutRows},
        {"index", "CREATE INDEX i ON events(kind)"},
        {"expression_index", "CREATE INDEX i ON events(abs(x))"},
        {"partial_index", "CREATE INDEX i ON frames(stage) WHERE time > 0"},
        {"check", redefined("events", "x REAL", "x REAL CHECK (abs(x) >= 0)")},
        {"default", redefined("stages", "name TEXT", "name TEXT DEFAULT (randomblob(1000000))")},
        {"collation", redefined("about", "value TEXT", "value TEXT COLLATE NOCASE")},
        {"foreign_key", redefined("events", "stage INTEGER", "stage INTEGER REFERENCES stages ON DELETE CASCADE")},
        {"virtual_table", "CREATE VIRTUAL TABLE more USING rtree(id, a, b)"},
        {"virtual_in_place", "DROP TABLE events; CREATE VIRTUAL TABLE events USING rtree(event, stage, time)"},
        {"more_table", "CREATE TABLE more (x)"},
        {"renamed", "ALTER TABLE history RENAME TO past"},
        {"no_table", "DROP TABLE stages"},
        {"column_dropped", "ALTER TABLE frames DROP COLUMN block_extremes"},
        {"other_root",
         "PRAGMA writable_schema=ON; UPDATE sqlite_master SET rootpage = (SELECT rootpage FROM "
         "sqlite_master WHERE name = 'events') WHERE name = 'frames'; PRAGMA writable_schema=RESET"},
        {"statistics", "ANALYZE", true},
        {"vacuumed", "PRAGMA page_size=512; VACUUM", true},
        {"auto_vacuum", "PRAGMA auto_vacuum=FULL; VACUUM", true}};
    return stores;
}

class CraftedStores : public ::testing::TestWithParam<CraftedStore> {
protected:
    CraftedStores() {
        RunStoreWriter writer(path(), false);
        test::feed(test::sampleScene(), test::sampleResults(), writer);
        writer.close();
        sqlite3* database = nullptr;
        EXPECT_EQ(sqlite3_open(path().c_str(), &database), SQLITE_OK);
        const int code = sqlite3_exec(database, GetParam().sql.c_str(), nullptr, nullptr, nullptr);
        isMade_ = code == SQLITE_OK;
        made_ = sqlite3_errmsg(database);
        sqlite3_close(database);
    }

    fs::path path() const { return folder_.path() / "run.kbrun"; }

    /// What is said against the store when it is read by `work`; empty if it is read.
    template <typename Work>
    std::string refusal(Work work) const {
        const auto begun = std::chrono::steady_clock::now();
        std::string text;
        try {
            work();
        } catch (const CannotRead& error) {
            text = error.what();
        }
        EXPECT_LT(std::chrono::steady_clock::now() - begun, std::chrono::seconds(5));
        return text;
    }

    bool isMade_ = false;
    std::string made_;
    const test::ScratchFolder folder_;
};

TEST_P(CraftedStores, AreRefusedInWordsOrReadRight) {
    if (!isMade_) GTEST_SKIP() << "this SQLite cannot make it: " << made_;
    const std::string opened = refusal([&] { EXPECT_EQ(readResults(RunStore(path())), test::sampleResults()); });
    EXPECT_EQ(opened.empty(), GetParam().isRead) << opened;
    const std::string summary = refusal([&] { runSummary(path()); });
    const std::string resumed = refusal([&] { resumptionOf(path(), test::sampleScene()); });
    const std::string scene = refusal([&] { EXPECT_EQ(storedScene(path()), test::sampleScene()); });
    const StoredFrames frames(path(), std::make_shared<const Scene>(test::sampleScene()));
    const std::string frame = refusal([&] { EXPECT_EQ(frames.frame(0), test::sampleResults().frames[0]); });
    if (opened.find("it contains the") == std::string::npos) return;
    for (const std::string& text : {summary, resumed, scene, frame}) EXPECT_EQ(text, opened);
}

INSTANTIATE_TEST_SUITE_P(All, CraftedStores, ::testing::ValuesIn(craftedStores()),
                         [](const auto& tested) { return tested.param.name; });

TEST(CraftedDatabases, AStatementThatDoesNotEndIsInterrupted) {
    sqlite::Database database(":memory:", sqlite::Access::Create);
    try {
        sqlite::Statement(database, endless + "SELECT count(*) FROM n").next();
        ADD_FAILURE();
    } catch (const sqlite::Error& error) {
        EXPECT_EQ(error.code, SQLITE_INTERRUPT);
    }
    sqlite::Statement after(database, "SELECT 7");  // the next statement has its own allowance
    EXPECT_TRUE(after.next());
}

TEST(CraftedDatabases, TriggersAndViewsAreNotExecuted) {
    sqlite::Database database(":memory:", sqlite::Access::Create);
    database.run(
        "CREATE TABLE t (x); CREATE TABLE u (x); CREATE TRIGGER g AFTER INSERT ON t BEGIN INSERT INTO u VALUES "
        "(1); END; CREATE VIEW v AS SELECT 1; INSERT INTO t VALUES (1)");
    sqlite::Statement count(database, "SELECT count(*) FROM u");
    ASSERT_TRUE(count.next());
    EXPECT_EQ(count.integer(0), 0);
    EXPECT_THROW(sqlite::Statement(database, "SELECT * FROM v"), sqlite::Error);
}

}  // namespace
}  // namespace keyblock
