// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A store gives back what went in, survives its writer, and refuses what it is not.
#include "solver/files/run_store/run_store.h"

#include "solver/files/run_store/checkpoint_bytes.h"
#include "solver/files/read_error.h"
#include "solver/files/run_store/resumption.h"
#include "solver/files/run_store/run_store_writer.h"
#include "solver/files/run_store/run_summary.h"
#include "solver/files/scene/scene_file.h"
#include "solver/files/sha256.h"
#include "solver/files/run_store/stored_frames.h"
#include "solver/results/tables.h"
#include "tests/scratch_folder.h"
#include "tests/solver/files/run_store/sealed_store.h"
#include "tests/solver/results/sample_run.h"

#include <gtest/gtest.h>

#include <sched.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <fstream>
#include <functional>
#include <limits>
#include <new>
#include <random>
#include <sstream>

namespace keyblock {
namespace {

namespace fs = std::filesystem;

class RunStoreTest : public ::testing::Test {
protected:
    fs::path storePath() const { return folder_.path() / "run.kbrun"; }

    void writeSample(bool overwrite = false) const {
        RunStoreWriter writer(storePath(), overwrite);
        test::feed(test::sampleScene(), test::sampleResults(), writer);
        writer.close();
    }

    std::string messageOnReading() const {
        try {
            const RunStore store(storePath());
            for (std::size_t index = 0; index < store.frames().size(); ++index)
                store.frame(index);
        } catch (const CannotRead& error) {
            return error.what();
        }
        return {};
    }

    std::size_t filesInFolder() const {
        return 
            std::distance(fs::directory_iterator(folder_.path()), fs::directory_iterator());
    }

    void runSql(const std::string& sql) const { sqlite::Database(storePath(), sqlite::Access::Write).run(sql); }

    const test::ScratchFolder folder_;
};

/// Runs `work` in a child process and waits for its end; the child exits 0 when `work` returns, 1 when it throws.
int childStatus(const std::function<void()>& work) {
    const pid_t child = ::fork();
    if (child == 0) {
        try {
            work();
        } catch (...) {
            ::_exit(1);
        }
        ::_exit(0);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    return status;
}

/// The sample's frame with another time and step.
Frame laterFrame(int count) {
    Frame frame = test::sampleResults().frames[1];
    frame.time = 1e-3 * count;
    frame.step = count;
    return frame;
}

TEST_F(RunStoreTest, GivesBackWhatWentIn) {
    writeSample();
    const RunStore store(storePath());
    EXPECT_EQ(store.scene(), test::sampleScene());
    EXPECT_EQ(readResults(store), test::sampleResults());
    EXPECT_EQ(store.sceneHash(), sha256(sceneText(test::sampleScene())));
    EXPECT_EQ(filesInFolder(), 1U);
}

TEST_F(RunStoreTest, GivesTheSameTablesAsMemory) {
    writeSample();
    const RunStore store(storePath());
    const Scene scene = test::sampleScene();
    const Results results = test::sampleResults();
    const MemoryRun memory(scene, results);
    const TableFilter everything{{}, {}, When::All, 0.0};
    for (const std::string_view word : tableWords()) {
        std::ostringstream fromStore;
        std::ostringstream fromMemory;
        writeTable(*tableKindOf(word), store, everything, fromStore);
        writeTable(*tableKindOf(word), memory, everything, fromMemory);
        EXPECT_EQ(fromStore.str(), fromMemory.str()) << word;
    }
}

TEST_F(RunStoreTest, DocumentsItsOwnColumns) {
    writeSample();
    const sqlite::Database database(storePath(), sqlite::Access::Read);
    sqlite::Statement widths(database,
                             "SELECT (SELECT length(nodes) FROM frames LIMIT 1) / 3, "
                             "8 * (SELECT count(*) FROM columns WHERE payload = 'nodes'), "
                             "(SELECT length(\"values\") FROM history LIMIT 1), "
                             "8 * (SELECT count(*) FROM columns WHERE payload = 'history')");
    ASSERT_TRUE(widths.next());
    EXPECT_EQ(widths.integer(0), widths.integer(1));
    EXPECT_EQ(widths.integer(2), widths.integer(3));
}

TEST_F(RunStoreTest, KeepsEveryCommittedFrameOfAKilledRun) {
    const int status = childStatus([&] {
        RunStoreWriter writer(storePath(), false);
        writer.begin(test::sampleScene(), test::sampleResults().columns);
        writer.stageBegins(0);
        for (int count = 0; count < 50; ++count) {
            writer.event(test::sampleResults().events[0]);
            writer.history(test::sampleResults().history[0]);
            writer.frame(laterFrame(count));
        }
        writer.event(test::sampleResults().events[0]);
        ::kill(::getpid(), SIGKILL);
    });
    ASSERT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL);
    const RunStore store(storePath());
    ASSERT_EQ(store.frames().size(), 50U);
    EXPECT_EQ(store.frame(49), laterFrame(49));
    EXPECT_EQ(store.events().size(), 50U);
    EXPECT_EQ(store.history().size(), 50U);
    ASSERT_EQ(store.stages().size(), 1U);
    EXPECT_FALSE(store.stages()[0].ended);
}

/// A counter that a child process shares.
class SharedCount {
public:
    SharedCount()
        : memory_(::mmap(nullptr, sizeof(std::atomic<int>), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0)),
          count_(new (memory_) std::atomic<int>(0)) {}
    ~SharedCount() { ::munmap(memory_, sizeof(std::atomic<int>)); }
    SharedCount(const SharedCount&) = delete;
    SharedCount& operator=(const SharedCount&) = delete;

    std::atomic<int>& operator*() const { return *count_; }

private:
    void* memory_;
    std::atomic<int>* count_;
};

/// Killed within every write of a store, and while another replaces it.
TEST_F(RunStoreTest, OpensAfterAKillAtAnyMoment) {
    constexpr int frames = 20, writes = frames + 4, ofReplacement = 6;
    int opened = 0;
    for (int write = 0; write < writes + ofReplacement; ++write) {
        for (const fs::directory_entry& left : fs::directory_iterator(folder_.path()))
            fs::remove(left);
        const SharedCount done;
        const pid_t child = ::fork();
        if (child == 0) {
            for (bool overwrite = false;; overwrite = true) {
                RunStoreWriter writer(storePath(), overwrite);
                ++*done;
                writer.begin(test::sampleScene(), test::sampleResults().columns);
                ++*done;
                writer.stageBegins(0);
                ++*done;
                for (int count = 0; count < frames; ++count) {
                    writer.frame(laterFrame(count));
                    ++*done;
                }
                writer.close();
                ++*done;
            }
        }
        // A wait that sleeps would be too late for the next write.
        while (*done < write && ::waitpid(child, nullptr, WNOHANG) == 0) ::sched_yield();
        ASSERT_GE(*done, write) << "the writer has ended";
        ::kill(child, SIGKILL);
        ::waitpid(child, nullptr, 0);
        if (!fs::exists(storePath()))
            continue;  // killed before the store had its scene
        const RunStore store(storePath());
        ++opened;
        for (std::size_t index = 0; index < store.frames().size(); ++index)
            ASSERT_EQ(store.frame(index), laterFrame(static_cast<int>(index)));
    }
    EXPECT_GE(opened, writes);
}

TEST_F(RunStoreTest, IsReadWhileItIsWritten) {
    RunStoreWriter writer(storePath(), false);
    writer.begin(test::sampleScene(), test::sampleResults().columns);
    writer.stageBegins(0);
    for (int count = 0; count < 3; ++count)
        writer.frame(laterFrame(count));
    const int status = childStatus([&] {
        const RunStore store(storePath());
        if (store.frames().size() != 3 || store.frame(2) != laterFrame(2))
            throw CannotRead("not what was committed");
    });
    EXPECT_EQ(status, 0);

    const RunStore snapshot(storePath());
    writer.history(test::sampleResults().history[0]);
    writer.frame(laterFrame(3));
    EXPECT_EQ(snapshot.frames().size(), 3U);
    EXPECT_TRUE(snapshot.history().empty());
    writer.close();
    EXPECT_EQ(snapshot.frame(2), laterFrame(2));
    EXPECT_EQ(RunStore(storePath()).frames().size(), 4U);
}

TEST_F(RunStoreTest, IsNotReplacedUnlessAsked) {
    writeSample();
    const std::string before = test::contentOf(storePath());
    EXPECT_THROW(writeSample(), StoreExists);
    EXPECT_EQ(test::contentOf(storePath()), before);
    writeSample(true);
    EXPECT_EQ(readResults(RunStore(storePath())), test::sampleResults());
    EXPECT_EQ(filesInFolder(), 1U);
}

TEST_F(RunStoreTest, ReplacesTheStoreOfAKilledRun) {
    childStatus([&] {
        RunStoreWriter writer(storePath(), false);
        writer.begin(test::sampleScene(), test::sampleResults().columns);
        writer.stageBegins(0);
        for (int count = 0; count < 20; ++count)
            writer.frame(laterFrame(count));
        ::kill(::getpid(), SIGKILL);
    });
    ASSERT_TRUE(fs::exists(storePath().string() + "-wal"));
    writeSample(true);
    EXPECT_EQ(readResults(RunStore(storePath())), test::sampleResults());
    EXPECT_EQ(filesInFolder(), 1U);
}

TEST_F(RunStoreTest, TakesNothingFromAJournalWhoseStoreWasRemoved) {
    for (const char* ending : {"-wal", "-journal"}) {
        {
            sqlite::Database old(storePath(), sqlite::Access::Create);
            old.run(std::string("PRAGMA journal_mode=") + (ending == std::string("-wal") ? "WAL" : "PERSIST") +
                    "; CREATE TABLE old (x); INSERT INTO old VALUES (randomblob(200000));");
            old.run("BEGIN; UPDATE old SET x = randomblob(200000); PRAGMA cache_spill=1; PRAGMA cache_size=1;"
                    "INSERT INTO old SELECT randomblob(100000) FROM old;");
            fs::copy_file(storePath().string() + ending, folder_.path() / "kept");
            old.run("ROLLBACK");
        }
        for (const char* gone : {"", "-wal", "-shm", "-journal"}) fs::remove(storePath().string() + gone);
        fs::rename(folder_.path() / "kept", storePath().string() + ending);
        writeSample();
        EXPECT_EQ(messageOnReading(), "") << ending;
        EXPECT_EQ(filesInFolder(), 1u) << ending;
        fs::remove(storePath());
    }
}

TEST_F(RunStoreTest, OverwritesNothingButRunStores) {
    test::putContent(storePath(), "notes of the user");
    EXPECT_THROW(writeSample(true), StoreExists);
    EXPECT_EQ(test::contentOf(storePath()), "notes of the user");
    test::putContent(storePath(), "");
    writeSample(true);
    EXPECT_EQ(messageOnReading(), "");
}

TEST_F(RunStoreTest, RefusesWhatIsNoStore) {
    EXPECT_NE(messageOnReading().find("no such file"), std::string::npos);
    test::putContent(storePath(), "");
    EXPECT_NE(messageOnReading().find("empty"), std::string::npos);
    test::putContent(storePath(), "{\"format\": \"keyblock-scene\"}");
    EXPECT_NE(messageOnReading().find("not a run store"), std::string::npos);
    fs::remove(storePath());
    fs::create_directory(storePath());
    EXPECT_NE(messageOnReading().find("not a file"), std::string::npos);
}

TEST_F(RunStoreTest, RefusesOtherDatabasesAndVersions) {
    writeSample();
    runSql("PRAGMA user_version=99");
    EXPECT_NE(messageOnReading().find("version 99"), std::string::npos);
    runSql("PRAGMA application_id=7");
    EXPECT_NE(messageOnReading().find("not a run store"), std::string::npos);
}

TEST_F(RunStoreTest, RefusesATruncatedStore) {
    writeSample();
    const auto size = fs::file_size(storePath());
    for (const auto part : {size / 2, size - 4096, std::uintmax_t{4096}, std::uintmax_t{100}, std::uintmax_t{20}}) {
        fs::resize_file(storePath(), part);
        EXPECT_NE(messageOnReading().find("damaged"), std::string::npos) << part << " of " << size << " bytes";
        fs::remove(storePath());
        writeSample();
    }
}

TEST_F(RunStoreTest, RefusesDamagedValues) {
    const auto damagedBy = [&](const std::string& sql) {
        fs::remove(storePath());
        writeSample();
        sqlite::Database database(storePath(), sqlite::Access::Write);
        database.run(sql);
        if (sql.find("DROP") == std::string::npos) test::seal(database);
        try {
            readResults(RunStore(storePath()));
        } catch (const CannotRead&) {
            return true;
        }
        return false;
    };
    EXPECT_TRUE(damagedBy("UPDATE frames SET nodes = zeroblob(7)"));
    EXPECT_TRUE(damagedBy("UPDATE frames SET weights = zeroblob(16)"));
    EXPECT_TRUE(damagedBy("UPDATE frames SET inertia = zeroblob(24)"));
    EXPECT_TRUE(damagedBy("UPDATE frames SET contact_forces = zeroblob(64)"));
    EXPECT_TRUE(damagedBy("UPDATE frames SET other_forces = x'0000000000000040' || zeroblob(56)"));
    EXPECT_TRUE(damagedBy("UPDATE frames SET blocks = zeroblob(96)"));
    EXPECT_TRUE(damagedBy("UPDATE frames SET corners = x'000000000000F87F' || zeroblob(16)"));
    EXPECT_TRUE(damagedBy("UPDATE frames SET corners = x''"));  // blocks without corners
    EXPECT_TRUE(damagedBy("UPDATE frames SET corners = substr(corners, 1, 72)"));  // a block with three of its corners
    // blocks without corners that have no area, as excavated ones, but not exactly
    for (const char* area : {"000000000000F87F", "000000000000F0BF"})
        EXPECT_TRUE(damagedBy("UPDATE frames SET corners = x'', blocks = x'" + std::string(160, '0') + area +
                              std::string(16, '0') + "' || x'" + std::string(192, '0') + "'"))
            << area;
    EXPECT_TRUE(damagedBy("UPDATE frames SET stage = 9"));
    EXPECT_TRUE(damagedBy("UPDATE events SET bolt = 4"));
    EXPECT_TRUE(damagedBy("UPDATE events SET kind = 'surprise'"));
    EXPECT_TRUE(damagedBy("UPDATE history SET \"values\" = zeroblob(8)"));
    EXPECT_TRUE(damagedBy("UPDATE stages SET outcome = 'won'"));
    EXPECT_TRUE(damagedBy("UPDATE about SET value = '{' WHERE key = 'scene'"));
    EXPECT_TRUE(damagedBy("DROP TABLE history"));
}

/// Everything that is shown of a run is guarded by a checksum, and so is the number of rows.
TEST_F(RunStoreTest, RefusesResultsThatHaveChanged) {
    const auto isRefusedAfter = [&](const std::string& sql) {
        fs::remove(storePath());
        writeSample();
        runSql(sql);
        try {
            readResults(RunStore(storePath()));
        } catch (const CannotRead& error) {
            return std::string(error.what()).find("damaged") != std::string::npos;
        }
        return false;
    };
    for (const std::string sql :
         {"UPDATE frames SET kinetic = kinetic + 1e-9", "UPDATE frames SET events = events + 1",
          "UPDATE frames SET blocks = substr(blocks, 1, 40) || x'01' || substr(blocks, 42)",
          "UPDATE frames SET block_extremes = x'01' || substr(block_extremes, 2)",
          "UPDATE history SET \"values\" = x'01' || substr(\"values\", 2)", "UPDATE history SET time = time + 1",
          "UPDATE events SET x = x + 1e-9", "UPDATE events SET slip = NULL", "UPDATE stages SET steps = steps + 1",
          "UPDATE stages SET outcome = NULL", "UPDATE stages SET message = message || '.'",
          "UPDATE about SET value = '9.9' WHERE key = 'program_version'", "DELETE FROM about WHERE key = 'scene_hash'",
          "DELETE FROM frames WHERE frame = (SELECT max(frame) FROM frames)",
          "DELETE FROM history WHERE row = (SELECT max(row) FROM history)", "DELETE FROM events WHERE event = 1",
          "DELETE FROM stages WHERE stage = (SELECT max(stage) FROM stages)"})
        EXPECT_TRUE(isRefusedAfter(sql)) << sql;
}

/// `make flips` reads more of them with every command.
TEST_F(RunStoreTest, AFlippedBitChangesNothingThatIsRead) {
    writeSample();
    const std::string whole = test::contentOf(storePath());
    const Results results = test::sampleResults();
    std::mt19937 random(3);
    int refused = 0;
    for (int flip = 0; flip < 100; ++flip) {
        std::string flipped = whole;
        flipped[random() % flipped.size()] ^= static_cast<char>(1u << random() % 8);
        test::putContent(storePath(), flipped);
        try {
            const RunStore store(storePath());
            EXPECT_EQ(readResults(store), results) << flip;
            EXPECT_EQ(store.scene(), test::sampleScene()) << flip;
        } catch (const CannotRead&) {
            ++refused;
        }
    }
    EXPECT_GT(refused, 15);
}

/// A store that was deleted, moved or replaced during its run: nothing is lost, and the run ends at once.
class LostStore : public RunStoreTest {
protected:
    /// Writes a frame, lets `lose` take the store away, and writes another. \return what the writer says.
    std::string messageAfter(const std::function<void()>& lose) const {
        RunStoreWriter writer(storePath(), false);
        writer.begin(test::sampleScene(), test::sampleResults().columns);
        writer.stageBegins(0);
        writer.frame(laterFrame(0));
        lose();
        try {
            writer.frame(laterFrame(1));
        } catch (const CannotWrite& error) {
            return error.what();
        }
        return "";
    }

    void expectBothFrames(const fs::path& path) const {
        const RunStore store(path);
        ASSERT_EQ(store.frames().size(), 2u);
        for (int count : {0, 1}) EXPECT_EQ(store.frame(count), laterFrame(count));
    }
};

TEST_F(LostStore, ThatWasMovedHasAllResults) {
    const fs::path moved = folder_.path() / "moved.kbrun";
    const std::string message = messageAfter([&] { fs::rename(storePath(), moved); });
    EXPECT_NE(message.find("are in " + moved.string()), std::string::npos) << message;
    expectBothFrames(moved);
    EXPECT_FALSE(fs::exists(storePath().string() + "-wal"));
}

TEST_F(LostStore, ThatWasDeletedIsThereAgain) {
    const std::string message = messageAfter([&] { fs::remove(storePath()); });
    EXPECT_NE(message.find("are in " + storePath().string()), std::string::npos) << message;
    expectBothFrames(storePath());
    EXPECT_EQ(filesInFolder(), 1u);
}

TEST_F(LostStore, ThatWasDeletedWithItsJournalIsThereAgain) {
    messageAfter([&] {
        for (const char* ending : {"", "-wal", "-shm"}) fs::remove(storePath().string() + ending);
    });
    expectBothFrames(storePath());
    EXPECT_EQ(filesInFolder(), 1u);
}

TEST_F(LostStore, ThatWasReplacedLeavesTheOtherFileAlone) {
    const std::string message = messageAfter([&] {
        fs::remove(storePath());
        test::putContent(storePath(), "notes of the user");
    });
    const fs::path kept = folder_.path() / "run-2.kbrun";
    EXPECT_NE(message.find("are in " + kept.string()), std::string::npos) << message;
    expectBothFrames(kept);
    EXPECT_EQ(test::contentOf(storePath()), "notes of the user");
}

TEST_F(RunStoreTest, SaysWhenAnotherProgramKeepsItLocked) {
    RunStoreWriter writer(storePath(), false, std::chrono::milliseconds(50));
    writer.begin(test::sampleScene(), test::sampleResults().columns);
    sqlite::Database other(storePath(), sqlite::Access::Write);
    other.run("BEGIN IMMEDIATE");
    try {
        writer.stageBegins(0);
        ADD_FAILURE();
    } catch (const CannotWrite& error) {
        EXPECT_NE(std::string(error.what()).find("another program keeps it locked"), std::string::npos) << error.what();
        EXPECT_NE(std::string(error.what()).find("--resume"), std::string::npos) << error.what();
    }
}

TEST_F(RunStoreTest, SaysWhenItWasCopiedWithoutItsJournal) {
    childStatus([&] {
        RunStoreWriter writer(storePath(), false);
        writer.begin(test::sampleScene(), test::sampleResults().columns);
        writer.stageBegins(0);
        writer.frame(laterFrame(0));
        ::kill(::getpid(), SIGKILL);
    });
    const fs::path copy = folder_.path() / "copy.kbrun";
    fs::copy_file(storePath(), copy);
    for (int time = 0; time < 2; ++time) EXPECT_TRUE(RunStore(copy).mayLackResults()) << time;
    EXPECT_FALSE(RunStore(storePath()).mayLackResults());
    writeSample(true);
    EXPECT_FALSE(RunStore(storePath()).mayLackResults());
}

TEST_F(RunStoreTest, SaysWhenItCannotWrite) {
    RunStoreWriter writer(folder_.path() / "missing" / "run.kbrun", false);
    try {
        writer.begin(test::sampleScene(), test::sampleResults().columns);
        FAIL() << "wrote into a folder that is not there";
    } catch (const CannotWrite& error) {
        EXPECT_NE(std::string(error.what()).find("No such file"), std::string::npos) << error.what();
    }
    EXPECT_EQ(filesInFolder(), 0U);
}

TEST_F(RunStoreTest, SaysWhenAFolderMayNotBeWritten) {
    fs::permissions(folder_.path(), fs::perms(0555));
    const int status = childStatus([&] {
        if (::geteuid() == 0 && ::setuid(65534) != 0)
            throw std::runtime_error("root may write everywhere");
        RunStoreWriter writer(storePath(), false);
        try {
            writer.begin(test::sampleScene(), test::sampleResults().columns);
        } catch (const CannotWrite& error) {
            if (std::string(error.what()).find("Permission denied") != std::string::npos)
                return;
        }
        throw std::logic_error("not reported");
    });
    EXPECT_EQ(status, 0);
    fs::permissions(folder_.path(), fs::perms(0700));
}

TEST_F(RunStoreTest, GoesOnAfterACheckpoint) {
    const Results results = test::sampleResults();
    Checkpoint from;  // after the first stage's first frame
    {
        RunStoreWriter writer(storePath(), false);
        writer.begin(test::sampleScene(), results.columns);
        writer.stageBegins(0);
        writer.event(results.events[0]);
        writer.history(results.history[0]);
        writer.frame(results.frames[0]);
        from.begun = true;
        from.written = {1, 1, 1};
        writer.checkpoint(from);
        writer.event(results.events[1]);
        writer.history(results.history[1]);
        writer.frame(results.frames[1]);
        StageResult stopped = results.stages[0];
        stopped.outcome = Outcome::Stopped;
        writer.stageEnds(stopped);
    }
    const Resumption resumption = resumptionOf(storePath(), test::sampleScene());
    EXPECT_FALSE(resumption.finished);
    ASSERT_TRUE(resumption.checkpoint);
    EXPECT_EQ(bytesOf(*resumption.checkpoint), bytesOf(from));
    Scene other = test::sampleScene();
    other.title += " changed";
    EXPECT_THROW(resumptionOf(storePath(), other), CannotRead);
    {
        RunStoreWriter writer(storePath(), true);
        writer.resume(test::sampleScene(), results.columns, *resumption.checkpoint);
        EXPECT_THROW(RunStoreWriter(storePath(), true).resume(test::sampleScene(), results.columns, from), CannotWrite);
        const RunStore store(storePath());
        EXPECT_EQ(store.events().size(), 1u);
        EXPECT_EQ(store.history().size(), 1u);
        EXPECT_EQ(store.frames().size(), 1u);
        ASSERT_EQ(store.stages().size(), 1u);
        EXPECT_FALSE(store.stages()[0].ended);
    }
}

TEST_F(RunStoreTest, ADoneRunKeepsNoCheckpoint) {
    RunStoreWriter writer(storePath(), false);
    writer.begin(test::sampleScene(), test::sampleResults().columns);
    writer.stageBegins(0);
    writer.checkpoint({});
    EXPECT_TRUE(RunStore(storePath()).checkpoint());
    writer.stageEnds(test::sampleResults().stages[0]);
    EXPECT_TRUE(RunStore(storePath()).checkpoint());
    writer.stageBegins(1);
    writer.stageEnds(test::sampleResults().stages[1]);
    EXPECT_FALSE(RunStore(storePath()).checkpoint());
    writer.close();
    EXPECT_TRUE(resumptionOf(storePath(), test::sampleScene()).finished);
}

TEST_F(RunStoreTest, AFullDiskKeepsWhatWasCommitted) {
    // A limit on the size of files stands in for the disk.
    const int status = childStatus([&] {
        ::signal(SIGXFSZ, SIG_IGN);
        RunStoreWriter writer(storePath(), false);
        writer.begin(test::sampleScene(), test::sampleResults().columns);
        const rlimit limit{400000, 400000};
        ::setrlimit(RLIMIT_FSIZE, &limit);
        writer.stageBegins(0);
        try {
            for (int count = 0; count < 100000; ++count)
                writer.frame(laterFrame(count));
        } catch (const CannotWrite&) {
            return;
        }
        throw std::logic_error("the limit did not hold");
    });
    ASSERT_EQ(status, 0);
    const RunStore store(storePath());
    ASSERT_GT(store.frames().size(), 10U);
    const auto last = store.frames().size() - 1;
    EXPECT_EQ(store.frame(last), laterFrame(static_cast<int>(last)));
}

TEST_F(RunStoreTest, NumbersOutOfTheOrdinarySurvive) {
    Results results = test::sampleResults();
    results.frames[0].blocks[0].velocity = {std::numeric_limits<double>::infinity(), -0.0};
    results.frames[0].energy.kinetic = -std::numeric_limits<double>::infinity();
    results.history[0].values[0] = std::numeric_limits<double>::denorm_min();
    {
        RunStoreWriter writer(storePath(), false);
        test::feed(test::sampleScene(), results, writer);
    }
    EXPECT_EQ(readResults(RunStore(storePath())), results);
}

TEST_F(RunStoreTest, AnExcavatedBlockHasNoCorners) {
    Results results = test::sampleResults();
    results.frames.back().blocks.front() = {};
    {
        RunStoreWriter writer(storePath(), false);
        test::feed(test::sampleScene(), results, writer);
    }
    EXPECT_EQ(readResults(RunStore(storePath())), results);
}

TEST_F(RunStoreTest, FramesAreReadOneByOneWhileTheStoreIsWritten) {
    const Scene scene = test::sampleScene();
    const Results results = test::sampleResults();
    RunStoreWriter writer(storePath(), false);
    test::feed(scene, results, writer);  // not closed
    const RunStore whole(storePath());
    const StoredFrames frames(storePath(), std::make_shared<const Scene>(whole.scene()));
    for (std::size_t i = 0; i < whole.frames().size(); ++i) EXPECT_TRUE(frames.frame(i) == whole.frame(i)) << i;
    try {
        frames.frame(whole.frames().size());
        ADD_FAILURE() << "a frame that there is not was read";
    } catch (const CannotRead& error) {
        EXPECT_NE(std::string(error.what()).find("no longer has frame"), std::string::npos) << error.what();
    }
    writer.close();
    EXPECT_TRUE(frames.frame(0) == whole.frame(0));
}

TEST_F(RunStoreTest, ASummaryTellsWhatAListNeeds) {
    writeSample();
    const RunStore whole(storePath());
    const RunSummary summary = runSummary(storePath());
    EXPECT_EQ(summary.sceneHash, whole.sceneHash());
    EXPECT_EQ(summary.frames, static_cast<long>(whole.frames().size()));
    EXPECT_EQ(summary.events, static_cast<long>(whole.events().size()));
    EXPECT_EQ(summary.stages, static_cast<int>(whole.stages().size()));
    EXPECT_EQ(summary.outcome, whole.stages().back().result.outcome);
    EXPECT_FALSE(summary.resumable);
    EXPECT_THROW(runSummary(folder_.path() / "nowhere.kbrun"), CannotRead);
    std::ofstream(folder_.path() / "text.kbrun") << "this is no database, but long enough to look like one";
    EXPECT_THROW(runSummary(folder_.path() / "text.kbrun"), CannotRead);
}

}  // namespace
}  // namespace keyblock
