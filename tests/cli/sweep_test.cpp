// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The command `sweep`: the same results in any order, with any interruption and under
// any scheduler; every case has a row; refusals.
#include "tests/cli/command_line_fixture.h"

#include <nlohmann/json.hpp>

#include <signal.h>
#include <sys/wait.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <sstream>
#include <thread>

namespace keyblock::test {
namespace {

class SweepCommand : public CommandLine {
protected:
    /// A study of a block on an incline held by a bolt, beside its scene.
    void putStudy(int cases, const std::string& more = "") const {
        put("scene.json", contentOf(std::filesystem::path(KEYBLOCK_SAMPLES_DIR) / "bolted-incline.json"));
        put("study.json", R"({ "format": "keyblock-study", "version": 1, "scene": "scene.json",
  "plan": { "cases": )" + std::to_string(cases) +
                              R"(, "cases_per_task": 5 },
  "parameters": [ { "name": "friction", "path": "joint_materials.joint.friction_angle",
                    "distribution": { "kind": "normal", "mean": 36, "deviation": 3 } } ],
  "faults": [ { "name": "missing", "kind": "missing", "bolts": ["B"], "probability": 0.2 } ],
  "quantities": [ "max key.u", "max B.axial_force" ], "fails": "not stands")" +
                              more + " }\n");
    }

    void plan(const std::string& out, const std::string& study = "study.json") const {
        const Ended ended = keyblock({"sweep", "plan", study, "--out", out});
        ASSERT_EQ(ended.code, 0) << ended.err;
    }

    std::string collected(const std::string& sweep) const {
        const Ended ended = keyblock({"sweep", "collect", sweep});
        EXPECT_EQ(ended.code, 0) << ended.err;
        return content(sweep + "/results.csv");
    }

    nlohmann::json status(const std::string& sweep) const {
        return nlohmann::json::parse(keyblock({"sweep", "status", sweep, "--json"}).out);
    }

    static std::vector<std::string> cells(const std::string& line) {
        std::vector<std::string> result;
        std::istringstream in(line);
        for (std::string cell; std::getline(in, cell, ',');) result.push_back(cell);
        return result;
    }
};

/// Friction angle [°] at which the block of the sample is in limit equilibrium: W sin α = W cos α tan φ + T.
double limitAngle(double bolt) {
    constexpr double slope = 40.0 * std::numbers::pi / 180.0, weight = 2700.0 * 9.81;
    return std::atan((weight * std::sin(slope) - bolt) / (weight * std::cos(slope))) * 180.0 / std::numbers::pi;
}

TEST_F(SweepCommand, EveryCaseFailsAsItsLimitEquilibriumSays) {
    putStudy(60);
    plan("s");
    ASSERT_EQ(keyblock({"sweep", "run", "s", "--index", "1-60"}).code, 0);
    const std::vector<std::string> rows = lines(collected("s"));
    ASSERT_EQ(rows.size(), 61u);
    EXPECT_EQ(rows[0], "case,friction,missing,outcome,reason,stands,fails,max key.u_m,max B.axial_force_N");
    int fails = 0, missing = 0;
    for (std::size_t i = 1; i < rows.size(); ++i) {
        const std::vector<std::string> row = cells(rows[i]);
        const bool isMissing = row[2] == "1";
        EXPECT_EQ(row[3], "done") << rows[i];
        EXPECT_EQ(row[6] == "1", std::stod(row[1]) < limitAngle(isMissing ? 0.0 : 4000.0)) << rows[i];
        if (isMissing) {
            EXPECT_EQ(std::stod(row[8]), 0.0) << rows[i];
        }
        fails += row[6] == "1";
        missing += isMissing;
    }
    EXPECT_GT(fails, 5);
    EXPECT_GT(missing, 3);
    const nlohmann::json summary = nlohmann::json::parse(content("s/sweep.json"));
    EXPECT_EQ(summary["fails"]["cases"], fails);
    EXPECT_EQ(summary["outcomes"]["done"], 60);
    EXPECT_TRUE(exists("s/statistics.csv") && exists("s/correlations.csv") && exists("s/convergence.csv"));
#ifdef KEYBLOCK_HAS_FIGURES
    for (const char* figure : {"convergence", "histogram-max-key.u-m", "tornado-fails", "scatter-friction-max-key.u-m"})
        EXPECT_TRUE(exists("s/figures/" + std::string(figure) + ".svg")) << figure;
#endif
}

TEST_F(SweepCommand, AnyOrderAndSchedulerGiveTheSameBytes) {
    putStudy(20);
    for (const char* sweep : {"serial", "shuffled", "tasks"}) plan(sweep);
    ASSERT_EQ(keyblock({"sweep", "run", "serial", "--index", "1-20"}).code, 0);
    for (int i = 0; i < 20; ++i)
        ASSERT_EQ(keyblock({"sweep", "run", "shuffled", "--index", std::to_string(i * 7 % 20 + 1)}).code, 0);
    for (const char* task : {"3", "1", "4", "2"})
        ASSERT_EQ(keyblock({"sweep", "run", "tasks"}, {{"SLURM_ARRAY_TASK_ID", task}}).code, 0);
    const std::string serial = collected("serial");
    EXPECT_EQ(collected("shuffled"), serial);
    EXPECT_EQ(collected("tasks"), serial);
    EXPECT_EQ(serial.find("not finished"), std::string::npos);
    EXPECT_EQ(keyblock({"sweep", "run", "tasks"}, {{"SLURM_ARRAY_TASK_ID", "5"}}).code, 2);
    EXPECT_EQ(keyblock({"sweep", "run", "tasks"}).code, 2);
    EXPECT_EQ(keyblock({"sweep", "run", "tasks", "--index", "21"}).code, 2);
    EXPECT_EQ(keyblock({"sweep", "run", "tasks", "--index", "4-3"}).code, 2);
}

TEST_F(SweepCommand, RunsUnderGnuParallel) {
    if (std::system("command -v parallel >/dev/null 2>&1") != 0) GTEST_SKIP() << "GNU parallel is not installed";
    putStudy(20);
    plan("serial");
    plan("parallel");
    ASSERT_EQ(keyblock({"sweep", "run", "serial", "--index", "1-20"}).code, 0);
    const std::string script = "'" + (folder() / "parallel/run-parallel.sh").string() + "' 2 >/dev/null 2>&1";
    ASSERT_EQ(std::system(script.c_str()), 0);
    EXPECT_EQ(collected("parallel"), collected("serial"));
}

/// A long case keeps its checkpoint when it is stopped, and its results are those of an uninterrupted one.
TEST_F(SweepCommand, AStoppedCaseIsResumed) {
    putEndlessScene();
    put("study.json", R"({ "format": "keyblock-study", "version": 1, "scene": "rest.json", "plan": { "cases": 2 },
  "parameters": [ { "path": "stages[0].duration", "values": [20] },
                  { "path": "analysis.sleep_tolerance", "values": [0] },
                  { "path": "joint_materials.joint.friction_angle",
                    "distribution": { "kind": "uniform", "least": 20, "most": 40 } } ],
  "quantities": [ "last top.uy", "energy_error" ], "keep": "all" })");
    plan("whole");
    plan("stopped");
    ASSERT_EQ(keyblock({"sweep", "run", "whole", "--index", "1-2"}).code, 0);
    Program program({"sweep", "run", "stopped", "--index", "1-2"}, folder());
    ASSERT_TRUE(waitForFrames("stopped/cases/0000/000001/run.kbrun", 20));
    const auto begun = std::chrono::steady_clock::now();
    program.signal(SIGTERM);
    program.signal(SIGTERM);  // schedulers repeat themselves
    EXPECT_EQ(program.wait().code, 75);
    EXPECT_LT(std::chrono::steady_clock::now() - begun, std::chrono::seconds(5));
    EXPECT_EQ(status("stopped")["interrupted"], 1);
    EXPECT_FALSE(exists("stopped/cases/0000/000001/summary.json"));
    Program killed({"sweep", "run", "stopped", "--index", "1-2"}, folder());
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    killed.signal(SIGKILL);
    killed.wait();
    EXPECT_EQ(keyblock({"sweep", "run", "stopped", "--index", "1-2"}).code, 0);
    EXPECT_EQ(status("stopped")["finished"], 2);
    EXPECT_EQ(collected("stopped"), collected("whole"));
}

TEST_F(SweepCommand, AFinishedCaseIsSkippedAndAnInvalidOneIsARow) {
    putStudy(5, R"(, "keep": "thin")");
    std::string study = content("study.json");
    study.replace(study.find("\"mean\": 36"), 10, "\"mean\":  4");
    put("study.json", study);
    plan("s");
    ASSERT_EQ(keyblock({"sweep", "run", "s", "--index", "1-5"}).code, 0);
    EXPECT_TRUE(keyblock({"sweep", "run", "s", "--index", "1-5"}).out.empty());
    const std::vector<std::string> rows = lines(collected("s"));
    ASSERT_EQ(rows.size(), 6u);
    int invalid = 0;
    for (std::size_t i = 1; i < rows.size(); ++i) {
        if (std::stod(cells(rows[i])[1]) >= 0.0) continue;
        ++invalid;
        EXPECT_NE(rows[i].find("invalid"), std::string::npos) << rows[i];
        EXPECT_NE(rows[i].find("out of range for 'friction_angle'"), std::string::npos) << rows[i];
    }
    EXPECT_EQ(status("s")["outcomes"]["invalid"], invalid);
    for (int number = 1; number <= 5; ++number) {
        const std::string store = "s/cases/0000/00000" + std::to_string(number) + "/run.kbrun";
        if (exists(store)) {
            EXPECT_EQ(keyblock({"info", store}).code, 0);
        }
    }
}

/// A case that ends its process each time must not keep a task from its other cases.
TEST_F(SweepCommand, ACaseThatNeverEndsBecomesARow) {
    putStudy(2);
    plan("s");
    std::filesystem::create_directories(folder() / "s/cases/0000/000001");
    put("s/cases/0000/000001/starts", "-1 5\n");
    ASSERT_EQ(keyblock({"sweep", "run", "s", "--index", "1-2"}).code, 0);
    const std::vector<std::string> rows = lines(collected("s"));
    ASSERT_EQ(rows.size(), 3u);
    EXPECT_NE(rows[1].find("ended without a result 5 times"), std::string::npos) << rows[1];
    EXPECT_NE(rows[2].find(",done,"), std::string::npos) << rows[2];
    EXPECT_EQ(status("s")["outcomes"]["error"], 1);
}

/// Plane sliding without cohesion: F = tan φ / tan α.
TEST_F(SweepCommand, TheFactorOfSafetyOfEachCaseIsThatOfItsClosedForm) {
    put("scene.json", contentOf(std::filesystem::path(KEYBLOCK_SAMPLES_DIR) / "slope-safety.json"));
    put("study.json", R"({ "format": "keyblock-study", "version": 1, "scene": "scene.json",
  "plan": { "kind": "full-factorial" }, "safety": true, "quantities": [ "stands" ],
  "parameters": [ { "name": "friction", "path": "joint_materials.joint.friction_angle", "values": [30, 45] },
                  { "path": "safety.tolerance", "values": [0.05] } ], "fails": "factor_of_safety < 1.2" })");
    plan("s");
    ASSERT_EQ(keyblock({"sweep", "run", "s", "--index", "1-2"}).code, 0);
    const std::vector<std::string> rows = lines(collected("s"));
    ASSERT_EQ(rows.size(), 3u);
    EXPECT_EQ(rows[0],
              "case,friction,safety.tolerance,outcome,reason,stands,fails,factor_of_safety,factor_of_safety_upper");
    for (std::size_t i = 1; i < 3; ++i) {
        const std::vector<std::string> row = cells(rows[i]);
        constexpr double degree = std::numbers::pi / 180.0;
        const double factor = std::tan(std::stod(row[1]) * degree) / std::tan(35.0 * degree);
        EXPECT_LE(std::stod(row[7]), 1.002 * factor) << rows[i];
        EXPECT_GE(std::stod(row[8]), 0.998 * factor) << rows[i];
        EXPECT_LE(std::stod(row[8]) - std::stod(row[7]), 0.05) << rows[i];
        EXPECT_EQ(row[6] == "1", factor < 1.2) << rows[i];
    }
}

TEST_F(SweepCommand, ATenTimesLargerPlanIsAsQuick) {
    putStudy(100000);
    const auto begun = std::chrono::steady_clock::now();
    plan("s");
    EXPECT_LT(std::chrono::steady_clock::now() - begun, std::chrono::seconds(10));
    const auto planned = std::chrono::steady_clock::now();
    EXPECT_EQ(status("s")["waiting"], 100000);
    EXPECT_LT(std::chrono::steady_clock::now() - planned, std::chrono::seconds(2));
    EXPECT_EQ(keyblock({"sweep", "run", "s", "--index", "99999"}).code, 0);
    EXPECT_EQ(status("s")["finished"], 1);
}

TEST_F(SweepCommand, OneCaseIsRunByOneProcess) {
    putEndlessScene();
    put("study.json", R"({ "format": "keyblock-study", "version": 1, "scene": "rest.json", "plan": { "cases": 1 },
  "parameters": [ { "path": "analysis.sleep_tolerance", "values": [0] } ], "quantities": [ "last top.uy" ] })");
    plan("s");
    Program first({"sweep", "run", "s", "--index", "1"}, folder());
    ASSERT_TRUE(waitForFrames("s/cases/0000/000001/run.kbrun", 2));
    const Ended second = keyblock({"sweep", "run", "s", "--index", "1"});
    EXPECT_EQ(second.code, 75);
    EXPECT_NE(second.err.find("being run by another process"), std::string::npos) << second.err;
    EXPECT_EQ(status("s")["running"], 1);
    first.signal(SIGTERM);
    EXPECT_EQ(first.wait().code, 75);
    EXPECT_EQ(status("s")["interrupted"], 1);
}

TEST_F(SweepCommand, AFullDiskEndsWith6AndTheCaseIsRunLater) {
    putStudy(1);
    plan("s");
    const std::string limited = "cd '" + folder().string() + "' && ulimit -f 16 && '" KEYBLOCK_PROGRAM "' sweep ";
    const int run = std::system((limited + "run s --index 1 2>run.txt").c_str());
    EXPECT_EQ(WEXITSTATUS(run), 6) << content("run.txt");
    EXPECT_NE(content("run.txt").find("cannot write"), std::string::npos) << content("run.txt");
    EXPECT_EQ(keyblock({"sweep", "run", "s", "--index", "1"}).code, 0);
    EXPECT_EQ(status("s")["outcomes"]["done"], 1);
    putStudy(5000);
    const int plan = std::system((limited + "plan study.json --out t 2>plan.txt").c_str());
    EXPECT_EQ(WEXITSTATUS(plan), 6) << content("plan.txt");
    EXPECT_FALSE(exists("t"));
}

TEST_F(SweepCommand, RefusesWhatItCannotDo) {
    putStudy(3);
    plan("s");
    EXPECT_EQ(keyblock({"sweep", "plan", "study.json", "--out", "s"}).code, 6);  // never over another
    EXPECT_EQ(keyblock({"sweep", "run", "nowhere", "--index", "1"}).code, 3);
    put("broken.json", R"({ "format": "keyblock-study", "version": 1, "scene": "scene.json" })");
    EXPECT_EQ(keyblock({"sweep", "plan", "broken.json", "--out", "t"}).code, 3);
    EXPECT_EQ(keyblock({"check", "broken.json"}).code, 3);
    EXPECT_EQ(keyblock({"check", "study.json"}).code, 0);
    EXPECT_EQ(keyblock({"sweep", "collect", "s", "--scatter", "friction,nothing"}).code, 2);
    put("s/scene.json", content("s/scene.json") + " ");
    const Ended changed = keyblock({"sweep", "run", "s", "--index", "1"});
    EXPECT_EQ(changed.code, 3);
    EXPECT_NE(changed.err.find("it was changed after the sweep was planned"), std::string::npos) << changed.err;
}

}  // namespace
}  // namespace keyblock::test
