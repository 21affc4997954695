// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A scene goes in, a store and tables come out: the same bytes on any number of
// threads and in any locale, and what is done is kept when a run is interrupted.
#include "tests/cli/command_line_fixture.h"
#include "tests/wait_for.h"

#include <nlohmann/json.hpp>

#include <signal.h>

#include <algorithm>
#include <clocale>
#include <cstdlib>

namespace keyblock::test {
namespace {

using Runs = CommandLine;
using nlohmann::json;

TEST_F(Runs, SumsUpWhatTheSceneAskedFor) {
    putPullScene();
    const Ended ended = keyblock({"run", "pull.json"});
    ASSERT_EQ(ended.code, 0) << ended.err;
    EXPECT_TRUE(ended.err.empty()) << ended.err;
    EXPECT_NE(ended.out.find("equilibrium"), std::string::npos) << ended.out;
    EXPECT_NE(ended.out.find("first debonding joint force"), std::string::npos);
    EXPECT_NE(ended.out.find("met"), std::string::npos);
    // The second expectation is wrong on purpose: reported, without an error.
    EXPECT_NE(ended.out.find("missed"), std::string::npos);
    EXPECT_NE(ended.out.find("-50.00 %"), std::string::npos) << ended.out;
}

TEST_F(Runs, TablesHaveTheirHeadersAndMeetTheSummary) {
    putPullScene();
    ASSERT_EQ(keyblock({"run", "pull.json"}).code, 0);
    EXPECT_EQ(lines(table("pull.kbrun", "history"))[0], "stage,time_s,dilation_m,joint_force_N");
    EXPECT_EQ(lines(table("pull.kbrun", "bolts")).size(), 1U + 16U);
    EXPECT_EQ(lines(table("pull.kbrun", "blocks")).size(), 1U + 2U);
    EXPECT_GT(lines(table("pull.kbrun", "energy")).size(), 10U);
    EXPECT_EQ(lines(table("pull.kbrun", "contacts"))[0].rfind("stage,time_s,block_a,block_b,", 0), 0U);
    EXPECT_EQ(lines(table("pull.kbrun", "forces"))[0], "stage,time_s,block,source,name,x_m,y_m,fx_N,fy_N,moment_Nm");
    EXPECT_GT(lines(table("pull.kbrun", "forces", {"--at", "all"})).size(),
              lines(table("pull.kbrun", "forces", {"--at", "last"})).size());
    const auto events = lines(table("pull.kbrun", "events", {"--bolt", "B"}));
    EXPECT_EQ(events[0],
              "stage,time_s,step,kind,bolt,node,element,block,x_m,y_m,axial_force_N,shear_force_N,anchor_force_N,"
              "slip_m");
    const json info = json::parse(keyblock({"info", "pull.kbrun", "--json"}).out);
    EXPECT_GT(info.at("events").at("debonding").get<int>(), 0);
    const auto debondings = std::count_if(events.begin(), events.end(), [](const std::string& line) {
        return line.find(",debonding,B,") != std::string::npos;
    });
    EXPECT_EQ(info.at("events").at("debonding").get<long>(), debondings);
}

TEST_F(Runs, InfoHasTheKeysOfTheContract) {
    putPullScene();
    ASSERT_EQ(keyblock({"run", "pull.json"}).code, 0);
    const json info = json::parse(keyblock({"info", "pull.kbrun", "--json"}).out);
    EXPECT_EQ(info.at("scene_hash").get<std::string>().size(), 64U);
    EXPECT_EQ(info.at("stages").at(0).at("name"), "pull");
    EXPECT_EQ(info.at("stages").at(0).at("kind"), "static");
    EXPECT_EQ(info.at("stages").at(0).at("outcome"), "equilibrium");
    EXPECT_EQ(info.at("stages").at(0).at("time_s"), 1.0);
    EXPECT_GE(info.at("stages").at(0).at("steps").get<int>(), 10);
    EXPECT_GE(info.at("frames").get<int>(), 10);
    for (const char* key : {"passes_mean", "step_cuts", "energy_cuts", "max_penetration_ratio", "balance_error", "residual"})
        EXPECT_TRUE(info.at("health").at(key).is_number()) << key;
}

TEST_F(Runs, InfoTellsCausesAndWhatBoltsTook) {
    putPullScene();
    ASSERT_EQ(keyblock({"run", "pull.json"}).code, 0);
    const json info = json::parse(keyblock({"info", "pull.kbrun", "--json"}).out);
    ASSERT_FALSE(info.at("chains").empty());
    const json& chain = info.at("chains").at(0);
    ASSERT_GE(chain.size(), 2U);
    EXPECT_EQ(chain.at(0).at("cause"), -1);
    EXPECT_EQ(chain.at(1).at("cause"), chain.at(0).at("event"));
    EXPECT_EQ(chain.at(1).at("bolt"), "B");
    ASSERT_EQ(info.at("bolts").size(), 1U);
    EXPECT_EQ(info.at("bolts").at(0).at("name"), "B");
    EXPECT_GT(info.at("bolts").at(0).at("bond_J").get<double>(), 0.0);
    EXPECT_GT(info.at("bolts").at(0).at("elastic_J").get<double>(), 0.0);
    EXPECT_EQ(info.at("bolts").at(0).at("plastic_J"), 0.0);
    const std::string text = keyblock({"info", "pull.kbrun"}).out;
    EXPECT_NE(text.find("chains of failures"), std::string::npos) << text;
    EXPECT_NE(text.find("energy taken by bolt"), std::string::npos) << text;
}

TEST_F(Runs, InfoGivesTheUseOfEveryBolt) {
    putPullScene();
    const Ended run = keyblock({"run", "pull.json"});
    ASSERT_EQ(run.code, 0);
    const json bolt = json::parse(keyblock({"info", "pull.kbrun", "--json"}).out).at("bolts").at(0);
    EXPECT_EQ(bolt.at("bolt"), "B");
    double largest = 0.0;
    for (const std::string& line : lines(table("pull.kbrun", "history")))
        if (line.rfind("pull,", 0) == 0) largest = std::max(largest, std::stod(line.substr(line.rfind(',') + 1)));
    EXPECT_GE(bolt.at("axial_N").get<double>(), largest * (1.0 - 1e-12));
    EXPECT_LE(bolt.at("axial_N").get<double>(), 1.01 * largest);
    EXPECT_NEAR(bolt.at("axial_at_m").get<double>(), 0.25, 0.04);  // at the joint
    EXPECT_EQ(bolt.at("stage"), "pull");
    EXPECT_GT(bolt.at("time_s").get<double>(), 0.0);
    for (const char* key : {"shear_N", "moment_Nm"}) EXPECT_TRUE(bolt.at(key).is_number()) << key;
    EXPECT_TRUE(bolt.at("use").at("steel").is_null());  // the type has no limit
    EXPECT_TRUE(bolt.at("use").at("shear").is_null());
    EXPECT_TRUE(bolt.at("use").at("plate").is_null());
    EXPECT_GE(bolt.at("use").at("bond").get<double>(), 1.0 - 1e-6);
    EXPECT_EQ(bolt.at("governs"), "bond");
    EXPECT_EQ(bolt.at("holds"), json::array({"right"}));
    const std::string text = keyblock({"info", "pull.kbrun"}).out;
    const auto from = text.find("largest forces of each bolt");
    ASSERT_NE(from, std::string::npos) << text;
    const std::string summary = text.substr(from, text.find("\n\n", from) - from);
    EXPECT_NE(run.out.find(summary), std::string::npos) << run.out << summary;  // the same figures
    EXPECT_NE(summary.find("bond  "), std::string::npos) << summary;
    EXPECT_NE(summary.find("right"), std::string::npos) << summary;
}

TEST_F(Runs, TheSummaryListsTheTenBoltsWithTheHighestUse) {
    putPullScene();
    json scene = json::parse(content("pull.json"));
    const json bolt = scene.at("bolts").at(0);
    scene["bolts"] = json::array();
    for (int i = 0; i < 12; ++i) {
        json one = bolt;
        one["name"] = "B" + std::to_string(i);
        one["far_end"][1] = one["head"][1] = 0.2 + 0.05 * i;
        if (i == 7) one["head"][0] = 1.1;  // the shortest
        scene["bolts"].push_back(one);
    }
    for (const char* key : {"monitors", "quantities", "about"}) scene.erase(key);
    scene["stages"][0]["motions"][0]["table"] = json::parse("[[0, 0], [1, 1e-4]]");
    put("many.json", scene.dump());
    const Ended run = keyblock({"run", "many.json"});
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_NE(run.out.find("and 2 more with lower use; all are in 'info --json'"), std::string::npos) << run.out;
    EXPECT_NE(run.out.find("and 2 more with less energy"), std::string::npos) << run.out;
    const std::string listed = run.out.substr(run.out.find("largest forces of each bolt"));
    EXPECT_EQ(lines(listed).at(2).rfind("B7 ", 0), 0U) << listed;
    EXPECT_EQ(json::parse(keyblock({"info", "many.kbrun", "--json"}).out).at("bolts").size(), 12U);
}

TEST_F(Runs, ACollapseNamesTheJointsAndBoltsThatFailed) {
    putPullScene();
    const Ended run = keyblock({"run", "pull.json", "--set", "analysis.gravity=[98.1,0]", "stages[0].motions=[]",
                                "stages[0].increments=null", "about.expected=[]"});
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_NE(run.out.find("failed joints around them"), std::string::npos) << run.out;
    EXPECT_NE(run.out.find("right on left"), std::string::npos) << run.out;
    EXPECT_NE(run.out.find("failed bolts across them"), std::string::npos) << run.out;
    const json verdict = json::parse(keyblock({"info", "pull.kbrun", "--json"}).out).at("verdict");
    EXPECT_EQ(verdict.at("stands"), false);
    ASSERT_EQ(verdict.at("joints").size(), 1U);
    const json& joint = verdict.at("joints").at(0);
    EXPECT_EQ(joint.at("block_a"), "right");
    EXPECT_EQ(joint.at("block_b"), "left");
    EXPECT_EQ(joint.at("mode"), "opened");
    EXPECT_GT(joint.at("opening_m").get<double>(), joint.at("slip_m").get<double>());
    ASSERT_FALSE(verdict.at("bolts").empty());
    EXPECT_EQ(verdict.at("bolts").back().at("bolt"), "B");
    EXPECT_EQ(verdict.at("bolts").back().at("event"), "debonding");
    EXPECT_EQ(verdict.at("bolts").back().at("stage"), "pull");
}

TEST_F(Runs, OneAndTwoThreadsGiveTheSameBytes) {
    putPullScene();
    ASSERT_EQ(keyblock({"run", "pull.json", "--threads", "1", "--out", "one.kbrun"}).code, 0);
    ASSERT_EQ(keyblock({"run", "pull.json", "--threads", "2", "--out", "two.kbrun"}).code, 0);
    for (const std::string name : {"history", "events", "bolts", "blocks", "contacts", "energy"})
        EXPECT_EQ(table("one.kbrun", name, {"--at", "all"}), table("two.kbrun", name, {"--at", "all"})) << name;
}

#ifdef KEYBLOCK_LOCALES
TEST_F(Runs, ALocaleWithDecimalCommasChangesNothing) {
    const std::string before = std::setlocale(LC_ALL, nullptr);
    setenv("LOCPATH", KEYBLOCK_LOCALES, 1);
    const bool isFound = std::setlocale(LC_ALL, "de_DE.UTF-8") != nullptr;
    std::setlocale(LC_ALL, before.c_str());
    ASSERT_TRUE(isFound);
    putPullScene();
    const std::map<std::string, std::string> german{
        {"LOCPATH", KEYBLOCK_LOCALES}, {"LC_ALL", "de_DE.UTF-8"}, {"LANG", "de_DE.UTF-8"}};
    ASSERT_EQ(keyblock({"run", "pull.json", "--out", "plain.kbrun"}).code, 0);
    ASSERT_EQ(keyblock({"run", "pull.json", "--out", "comma.kbrun"}, german).code, 0);
    ASSERT_EQ(keyblock({"export", "comma.kbrun", "--table", "history", "--out", "comma.csv"}, german).code, 0);
    EXPECT_EQ(content("comma.csv"), table("plain.kbrun", "history"));
    EXPECT_EQ(keyblock({"info", "comma.kbrun"}, german).out, keyblock({"info", "plain.kbrun"}).out);
}
#endif

TEST_F(Runs, OverridesReachTheScene) {
    putPullScene();
    const Ended ended = keyblock({"run", "--set", "stages[0].name=tear", "stages[0].increments=4", "pull.json"});
    ASSERT_EQ(ended.code, 0) << ended.err;
    EXPECT_EQ(json::parse(keyblock({"info", "pull.kbrun", "--json"}).out).at("stages").at(0).at("name"), "tear");
}

TEST_F(Runs, ProgressComesAsJsonLines) {
    putPullScene();
    const Ended ended = keyblock({"run", "pull.json", "--progress", "json"});
    ASSERT_EQ(ended.code, 0) << ended.err;
    const auto printed = lines(ended.err);
    ASSERT_FALSE(printed.empty());
    for (const std::string& line : printed) {
        const json progress = json::parse(line);
        EXPECT_EQ(progress.at("stage"), "pull");
        for (const char* key : {"time_s", "fraction", "eta_s", "passes", "events", "search"})
            EXPECT_TRUE(progress.contains(key)) << key;
    }
    EXPECT_NEAR(json::parse(printed.back()).at("fraction").get<double>(), 1.0, 1e-9);
}

TEST_F(Runs, TheBarShowsTheTimeLeft) {
    putEndlessScene();
    Program program({"run", "rest.json", "--progress", "bar", "--set", "stages[0].duration=3e5", "output.every=1e3"},
                    folder());
    const auto isEstimated = [&] { return program.errors().find(" left  ") != std::string::npos; };
    EXPECT_TRUE(waitFor(isEstimated)) << program.errors();
    program.signal(SIGINT);
    const Ended ended = program.wait();
    EXPECT_NE(ended.err.find("rest ["), std::string::npos) << ended.err;
}

TEST_F(Runs, AnInterruptedRunKeepsWhatIsDone) {
    putEndlessScene();
    const std::string expectation = "about.expected=[{\"quantity\": \"last top.uy\", \"value\": 1}]";
    for (const int signal : {SIGTERM, SIGINT}) {
        const std::string store = "rest-" + std::to_string(signal) + ".kbrun";
        Program program({"run", "rest.json", "--out", store, "--set", expectation}, folder());
        ASSERT_TRUE(waitForFrames(store));
        program.signal(signal);
        const Ended ended = program.wait();
        EXPECT_EQ(ended.code, 75) << ended.err;
        EXPECT_NE(ended.err.find("interrupted"), std::string::npos) << ended.err;
        EXPECT_NE(ended.out.find("incomplete"), std::string::npos) << ended.out;
        const Ended info = keyblock({"info", store, "--json"});
        ASSERT_EQ(info.code, 0) << info.err;
        EXPECT_EQ(json::parse(info.out).at("stages").at(0).at("outcome"), "stopped");
        EXPECT_GT(json::parse(info.out).at("frames").get<int>(), 0);
    }
}

TEST_F(Runs, AKilledRunLeavesAStoreThatOpens) {
    putEndlessScene();
    Program program({"run", "rest.json"}, folder());
    ASSERT_TRUE(waitForFrames("rest.kbrun"));
    const Ended live = keyblock({"info", "rest.kbrun", "--json"});
    EXPECT_EQ(live.code, 0) << live.err;
    program.signal(SIGKILL);
    EXPECT_EQ(program.wait().code, -1);
    const Ended info = keyblock({"info", "rest.kbrun", "--json"});
    ASSERT_EQ(info.code, 0) << info.err;
    EXPECT_TRUE(json::parse(info.out).at("stages").at(0).at("outcome").is_null());
    EXPECT_GE(json::parse(info.out).at("frames").get<int>(), json::parse(live.out).at("frames").get<int>());
    EXPECT_GT(lines(table("rest.kbrun", "blocks")).size(), 1U);
}

}  // namespace
}  // namespace keyblock::test
