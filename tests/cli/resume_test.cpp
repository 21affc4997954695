// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// When a run may go on and when not, and that no way to end spoils a store: a
// signal, a second one, a full disk, a second run.
#include "solver/files/run_store/checkpoint_bytes.h"
#include "solver/files/run_store/sqlite.h"
#include "solver/files/sha256.h"
#include "tests/cli/command_line_fixture.h"

#include <nlohmann/json.hpp>

#include <signal.h>
#include <sys/resource.h>

#include <chrono>

namespace keyblock::test {
namespace {

using nlohmann::json;

class Resume : public CommandLine {
protected:
    /// A run that was asked to stop after its first frames: `rest.kbrun`.
    void putStoppedRun() const {
        putEndlessScene();
        Program program({"run", "rest.json"}, folder());
        ASSERT_TRUE(waitForFrames("rest.kbrun", 5));
        program.signal(SIGTERM);
        const Ended ended = program.wait();
        ASSERT_EQ(ended.code, 75) << ended.err;
        EXPECT_NE(ended.err.find("--resume"), std::string::npos) << ended.err;
    }

    void runSql(const std::string& store, const std::string& sql) const {
        sqlite::Database(folder() / store, sqlite::Access::Write).run(sql);
    }

    void expectRefused(const std::vector<std::string>& more, int code, const std::string& part) const {
        std::vector<std::string> words{"run", "rest.json", "--resume"};
        words.insert(words.end(), more.begin(), more.end());
        const std::string before = content("rest.kbrun");
        const Ended ended = keyblock(words);
        EXPECT_EQ(ended.code, code) << ended.err;
        EXPECT_NE(ended.err.find(part), std::string::npos) << ended.err;
        EXPECT_EQ(content("rest.kbrun"), before);
    }

    std::size_t framesIn(const std::string& store) const {
        const Ended info = keyblock({"info", store, "--json"});
        EXPECT_EQ(info.code, 0) << info.err;
        return json::parse(info.out).at("frames").get<std::size_t>();
    }
};

TEST_F(Resume, WithoutAStoreItStartsAtTheBeginningAndAFinishedRunIsLeftAlone) {
    putPullScene();
    ASSERT_EQ(keyblock({"run", "pull.json", "--out", "whole.kbrun"}).code, 0);
    ASSERT_EQ(keyblock({"run", "pull.json", "--resume"}).code, 0);
    EXPECT_EQ(table("pull.kbrun", "bolts", {"--at", "all"}), table("whole.kbrun", "bolts", {"--at", "all"}));
    const std::string before = content("pull.kbrun");
    const Ended again = keyblock({"run", "pull.json", "--resume"});
    EXPECT_EQ(again.code, 0) << again.err;
    EXPECT_NE(again.out.find("equilibrium"), std::string::npos);
    EXPECT_EQ(content("pull.kbrun"), before);
    put("empty.kbrun", "");
    EXPECT_EQ(keyblock({"run", "pull.json", "--resume", "--out", "empty.kbrun"}).code, 0);
    EXPECT_EQ(table("empty.kbrun", "events"), table("whole.kbrun", "events"));
}

TEST_F(Resume, AnotherSceneIsRefused) {
    putStoppedRun();
    expectRefused({"--set", "stages[0].time_step=0.0005"}, 3, "another scene");
    put("rest.json", std::string(content("rest.json")).replace(content("rest.json").find("1e9"), 3, "2e9"));
    expectRefused({}, 3, "another scene");
    expectRefused({"--overwrite"}, 2, "--overwrite");
}

TEST_F(Resume, AnotherBuildOrADamagedCheckpointIsRefused) {
    putStoppedRun();
    runSql("rest.kbrun", "UPDATE checkpoint SET build = '0.0.1 abc'");
    expectRefused({}, 3, "another build");
    ASSERT_TRUE(std::filesystem::remove(folder() / "rest.kbrun"));
    putStoppedRun();
    runSql("rest.kbrun", "UPDATE checkpoint SET state = zeroblob(length(state))");
    expectRefused({}, 3, "damaged");
}

#if defined(__x86_64__)
/// The last digits may differ with the kernel of OpenBLAS. The message names the variable that selects the right one.
TEST_F(Resume, AnotherKernelOfOpenBlasIsRefused) {
    putStoppedRun();
    const std::string before = content("rest.kbrun");
    const std::string kernel = lines(keyblock({"--version"}).out).at(1).substr(std::string("OpenBLAS kernel ").size());
    const std::string other = kernel == "Prescott" ? "Nehalem" : "Prescott";
    const Ended refused = keyblock({"run", "rest.json", "--resume"}, {{"OPENBLAS_CORETYPE", other}});
    EXPECT_EQ(refused.code, 3);
    EXPECT_NE(refused.err.find("set OPENBLAS_CORETYPE=" + kernel + " and resume"), std::string::npos) << refused.err;
    EXPECT_EQ(content("rest.kbrun"), before);
}
#endif

/// With the right hash, as someone would make it who wants the program to take it.
TEST_F(Resume, ACheckpointThatDoesNotFitItsSceneIsRefused) {
    putStoppedRun();
    {
        sqlite::Database database(folder() / "rest.kbrun", sqlite::Access::Write);
        sqlite::Statement stored(database, "SELECT state FROM checkpoint");
        ASSERT_TRUE(stored.next());
        Checkpoint changed = checkpointOf(stored.bytes(0)).value();
        ASSERT_FALSE(changed.state.contacts.empty());
        changed.state.contacts[0].blockB = 1 << 30;
        const std::string bytes = bytesOf(changed);
        sqlite::Statement put(database, "UPDATE checkpoint SET state = ?, hash = ?");
        put.bindBytes(bytes).bind(sha256(bytes)).run();
    }
    expectRefused({}, 3, "does not fit its scene (blockB)");
}

TEST_F(Resume, AStoreThatIsDeletedDuringItsRunIsThereAgain) {
    putEndlessScene();
    Program program({"run", "rest.json"}, folder());
    ASSERT_TRUE(waitForFrames("rest.kbrun", 3));
    std::filesystem::remove(folder() / "rest.kbrun");
    const Ended ended = program.wait();  // the scene has no end of its own
    EXPECT_EQ(ended.code, 6) << ended.err;
    EXPECT_NE(ended.err.find("deleted, moved or replaced"), std::string::npos) << ended.err;
    EXPECT_GE(framesIn("rest.kbrun"), 3u);
}

TEST_F(Resume, WhatIsNoRunStoreIsRefused) {
    putEndlessScene();
    put("rest.kbrun", "notes of the user");
    expectRefused({}, 3, "not a run store");
}

TEST_F(Resume, WithoutACheckpointItStartsAtTheBeginning) {
    putPullScene();
    ASSERT_EQ(keyblock({"run", "pull.json"}).code, 0);
    const std::string expected = table("pull.kbrun", "history");
    runSql("pull.kbrun", "DELETE FROM stages; DELETE FROM frames; DELETE FROM events");
    ASSERT_EQ(keyblock({"run", "pull.json", "--resume"}).code, 0);
    EXPECT_EQ(table("pull.kbrun", "history"), expected);
    EXPECT_GT(lines(table("pull.kbrun", "events")).size(), 1u);
}

TEST_F(Resume, GoesOnPastWhereItStopped) {
    putStoppedRun();
    const std::size_t before = framesIn("rest.kbrun");
    Program program({"run", "rest.json", "--resume", "--progress", "json"}, folder());
    ASSERT_TRUE(waitForFrames("rest.kbrun", before));
    EXPECT_GT(framesIn("rest.kbrun"), before);  // read while it is written
    EXPECT_GT(lines(table("rest.kbrun", "blocks")).size(), 1u);
    program.signal(SIGINT);
    EXPECT_EQ(program.wait().code, 75);
    EXPECT_GT(framesIn("rest.kbrun"), before);
}

/// In four parts or more, each ended by the clock, a run writes what it writes at once.
TEST_F(Resume, ARunThatItsWallTimeEndsGoesOnToTheSameBytes) {
    putEndlessScene();
    const auto words = [](const std::string& store, const std::vector<std::string>& more) {
        std::vector<std::string> all{"run", "rest.json", "--out", store, "--set", "stages[0].duration=40",
                                     "stages[0].initial_velocities=[{\"block_at\": [1.5, 1.5], \"velocity\": [1, 0]}]"};
        all.insert(all.end(), more.begin(), more.end());
        return all;
    };
    const auto begun = std::chrono::steady_clock::now();
    ASSERT_EQ(keyblock(words("whole.kbrun", {})).code, 0);
    const std::chrono::duration<double> whole = std::chrono::steady_clock::now() - begun;
    const std::string wallTime = "limits.wall_time=" + std::to_string(whole.count() / 4.0);
    int parts = 1;
    Ended ended = keyblock(words("parts.kbrun", {wallTime}));
    for (; ended.code == 5 && parts < 50; ++parts) ended = keyblock(words("parts.kbrun", {wallTime, "--resume"}));
    ASSERT_EQ(ended.code, 0) << ended.err;
    EXPECT_GT(parts, 1);
    for (const std::string name : {"history", "events", "blocks", "contacts", "energy"})
        EXPECT_EQ(table("parts.kbrun", name, {"--at", "all"}), table("whole.kbrun", name, {"--at", "all"})) << name;
}

TEST_F(Resume, ASecondRunOnTheSameStoreIsRefused) {
    putStoppedRun();
    const std::size_t before = framesIn("rest.kbrun");
    Program program({"run", "rest.json", "--resume"}, folder());
    ASSERT_TRUE(waitForFrames("rest.kbrun", before));
    for (const std::string word : {"--resume", "--overwrite"}) {
        const Ended second = keyblock({"run", "rest.json", word});
        EXPECT_EQ(second.code, 6) << second.err;
        EXPECT_NE(second.err.find("another"), std::string::npos) << second.err;
    }
    program.signal(SIGTERM);
    EXPECT_EQ(program.wait().code, 75);
}

TEST_F(Resume, ASecondSignalEndsAtOnce) {
    putEndlessScene();
    Program program({"run", "rest.json"}, folder());
    ASSERT_TRUE(waitForFrames("rest.kbrun"));
    program.signal(SIGSTOP);  // so that both come at the same moment
    program.signal(SIGTERM);
    program.signal(SIGINT);
    program.signal(SIGCONT);
    EXPECT_EQ(program.wait().code, -1);
    EXPECT_GT(framesIn("rest.kbrun"), 0u);
}

TEST_F(Resume, AFullDiskIsReportedAndTheStoreStaysWhole) {
    putEndlessScene();
    rlimit usual{};
    ::getrlimit(RLIMIT_FSIZE, &usual);
    rlimit small = usual;
    small.rlim_cur = 600000;  // stands in for the disk; the program inherits it
    ::setrlimit(RLIMIT_FSIZE, &small);
    const Ended full = keyblock({"run", "rest.json"});
    ::setrlimit(RLIMIT_FSIZE, &usual);
    EXPECT_EQ(full.code, 6) << full.err;
    EXPECT_EQ(full.err.rfind("error: cannot write rest.kbrun: ", 0), 0u) << full.err;
    EXPECT_EQ(lines(full.err).size(), 1u) << full.err;
    const std::size_t frames = framesIn("rest.kbrun");
    EXPECT_GT(frames, 0u);
    Program program({"run", "rest.json", "--resume"}, folder());  // there is space again
    EXPECT_TRUE(waitForFrames("rest.kbrun", frames));
    program.signal(SIGTERM);
    EXPECT_EQ(program.wait().code, 75);
    EXPECT_GT(framesIn("rest.kbrun"), frames);
}

}  // namespace
}  // namespace keyblock::test
