// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Runs killed at random moments, taken up again, perhaps killed again, until they
// are done: every table then has the bytes of the run that nobody touched. `make
// kills` does it a hundred times; the suite a few. KEYBLOCK_KILLS and KEYBLOCK_STOPS
// say how often, KEYBLOCK_SEED which moments.
#include "tests/cli/command_line_fixture.h"

#include <signal.h>
#include <stdlib.h>
#include <unistd.h>

#include <chrono>
#include <iostream>
#include <random>

namespace keyblock::test {
namespace {

constexpr const char* head = R"({
  "format": "keyblock-scene", "version": 1,
  "analysis": { "plane": "stress", "gravity": [4, -8] },
  "materials": { "rock": { "density": 2700, "youngs_modulus": 5e9, "poissons_ratio": 0.2 } },
  "joint_materials": { "joint": { "friction_angle": 25, "cohesion": 0, "tensile_strength": 0 } },
  "supports": [ { "block_at": [0.5,0.1], "fix": "all" } ],
  "output": { "frames": 60 },)";

constexpr const char* boltedBlocks = R"(
  "blocks": [
    { "name": "left",  "points": [[0,0],[1,0],[1,1],[0,1]], "material": "rock", "joint_material": "joint" },
    { "name": "right", "points": [[1,0],[2,0],[2,1],[1,1]], "material": "rock", "joint_material": "joint" } ],
  "bolts": [ { "name": "B", "type": "rebar-20-paper", "far_end": [0.05,0.5], "head": [1.95,0.5], "divisions": 61,
               "plate": "none" } ],
  "monitors": [ { "name": "dilation", "between": [[0.999,0.2],[1.001,0.2]], "axis": "x" } ],)";

constexpr const char* looseBlocks = R"(
  "blocks": [
    { "name": "base", "points": [[-1,-1],[30,-1],[30,0],[-1,0]], "material": "rock", "joint_material": "joint" },
    { "name": "a", "points": [[0,0],[1,0],[1,1],[0,1]], "material": "rock", "joint_material": "joint" },
    { "name": "b", "points": [[0,1],[1,1],[1,2],[0,2]], "material": "rock", "joint_material": "joint" },
    { "name": "c", "points": [[2,0],[3,0],[2.5,1]], "material": "rock", "joint_material": "joint" },
    { "name": "d", "points": [[0,2],[1,2],[1,3],[0,3]], "material": "rock", "joint_material": "joint" } ],
  "monitors": [ { "name": "top", "point": [0.5,3] } ],)";

constexpr const char* pull = R"({ "name": "pull", "kind": "static", "increments": 150,
    "motions": [ { "block_at": [1.5,0.1], "axis": "x", "table": [[0,0],[1,0.01]] } ] })";
constexpr const char* swing = R"({ "name": "swing", "kind": "dynamic", "duration": 0.6, "time_step": 0.0005 })";

struct Killed {
    std::string name, text;
};

std::vector<Killed> scenes() {
    const std::string start(head), bolted = start + boltedBlocks;
    std::string loose = start + looseBlocks;
    loose.replace(loose.find("[0.5,0.1]"), 9, "[0.5,-0.5]");
    return {{"debonding", bolted + "\"stages\": [" + pull + "] }"},
            {"motion", loose + "\"stages\": [ { \"name\": \"slide\", \"kind\": \"dynamic\", \"duration\": 1.5, "
                               "\"time_step\": 0.0001 } ] }"},
            {"stages", bolted + "\"stages\": [ { \"name\": \"settle\", \"kind\": \"static\" }, " + pull + ", " + swing +
                           ", { \"name\": \"rest\", \"kind\": \"static\", \"zero_displacements\": true } ] }"}};
}

int countFrom(const char* variable, int usual) {
    const char* text = ::getenv(variable);
    return text ? std::atoi(text) : usual;
}

class Kills : public CommandLine {
protected:
    std::string allTables(const std::string& run) const {
        std::string all = keyblock({"info", run, "--json"}).out;
        for (const char* name : {"history", "events", "bolts", "blocks", "contacts", "energy"})
            all += table(run, name, {"--at", "all"});
        return all;
    }

    /// Sends `signal` at random moments, `count` times over all scenes, and lets every run end.
    void interrupt(int signal, int count, int codeExpected) {
        std::mt19937 random(static_cast<unsigned>(countFrom("KEYBLOCK_SEED", 1)));
        const std::vector<Killed> all = scenes();
        int sent = 0, late = 0, runs = 0;
        for (const Killed& scene : all) {
            put(scene.name + ".json", scene.text);
            const auto start = std::chrono::steady_clock::now();
            const Ended whole = keyblock({"run", scene.name + ".json", "--out", scene.name + ".kbrun"});
            ASSERT_EQ(whole.code, 0) << whole.err;
            const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
            const std::string expected = allTables(scene.name + ".kbrun");
            EXPECT_GT(expected.size(), 20000u);
            const int share = (count - sent) / static_cast<int>(&all.back() - &scene + 1);
            for (const int last = sent + share; sent < last; ++runs) {
                std::filesystem::remove(folder() / "cut.kbrun");
                for (int again = 1 + static_cast<int>(random() % 3); again > 0 && sent < last; --again) {
                    const double pause = seconds * static_cast<double>(random() % 1000) / 1000.0;
                    const int threads = 1 + static_cast<int>(random() % 2);
                    ++(cut(scene.name, signal, pause, codeExpected, threads) ? sent : late);
                }
                const Ended ended = keyblock({"run", scene.name + ".json", "--out", "cut.kbrun", "--resume"});
                EXPECT_EQ(ended.code, 0) << ended.err;
                EXPECT_TRUE(allTables("cut.kbrun") == expected) << scene.name << ", run " << runs;
                if (HasFailure()) return;
            }
        }
        std::cout << sent << " signals over " << runs << " runs; " << late << " more came after the run had ended\n";
    }

    /// \return false where the run ended first.
    bool cut(const std::string& name, int signal, double seconds, int codeExpected, int threads) {
        Program program({"run", name + ".json", "--out", "cut.kbrun", "--resume", "--threads", std::to_string(threads)},
                        folder());
        ::usleep(static_cast<useconds_t>(1e6 * seconds));
        program.signal(signal);
        const Ended ended = program.wait();
        // before the program listens, SIGTERM ends it as it ends any program
        EXPECT_TRUE(ended.code == codeExpected || ended.code == 0 || ended.code == -1) << ended.code << ended.err;
        return ended.code != 0;
    }
};

TEST_F(Kills, AKilledRunGoesOnAndEndsWithTheSameBytes) { interrupt(SIGKILL, countFrom("KEYBLOCK_KILLS", 6), -1); }

TEST_F(Kills, AStoppedRunGoesOnAndEndsWithTheSameBytes) { interrupt(SIGTERM, countFrom("KEYBLOCK_STOPS", 3), 75); }

}  // namespace
}  // namespace keyblock::test
