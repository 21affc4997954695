// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The factor of safety as a user asks for it: text, JSON, refusals with their
// places, and a bracket that an interruption leaves behind.
#include "tests/cli/command_line_fixture.h"
#include "tests/wait_for.h"

#include <nlohmann/json.hpp>

#include <signal.h>

#include <cmath>

namespace keyblock::test {
namespace {

using nlohmann::json;

class SafetyCommand : public CommandLine {
protected:
    /// A cube on a slope of 1 in 2 with tan φ = 1: the factor is 2.
    void putSlope() const {
        put("slope.json", R"({
  "format": "keyblock-scene", "version": 1,
  "analysis": { "gravity": [4.5, -9] },
  "materials": { "rock": { "density": 2700, "youngs_modulus": 1e9, "poissons_ratio": 0.2 } },
  "joint_materials": { "joint": { "friction_angle": 45 } },
  "blocks": [
    { "name": "floor", "points": [[0,0],[9,0],[9,1],[0,1]], "material": "rock" },
    { "name": "stone", "points": [[1,1],[3,1],[3,2],[1,2]], "material": "rock" } ],
  "supports": [ { "block_at": [0.5,0.5], "fix": "all" } ],
  "stages": [ { "name": "rest", "kind": "static" } ],
  "safety": { "reduce": "joints", "tolerance": 0.05 }
}
)");
    }
};

TEST_F(SafetyCommand, TellsTheBracketAndHowItFails) {
    putSlope();
    const Ended ended = keyblock({"safety", "slope.json"});
    ASSERT_EQ(ended.code, 0) << ended.err;
    EXPECT_TRUE(ended.err.empty()) << ended.err;
    for (const char* part : {"reduced: joints", "equilibrium", "collapse", "factor of safety between", "stone",
                             "slides", "floor on stone"})
        EXPECT_NE(ended.out.find(part), std::string::npos) << part << "\n" << ended.out;
}

TEST_F(SafetyCommand, AnswersInJson) {
    putSlope();
    const Ended ended = keyblock({"safety", "slope.json", "--json", "--set", "safety.tolerance=0.01"});
    ASSERT_EQ(ended.code, 0) << ended.err;
    const json answer = json::parse(ended.out);
    EXPECT_EQ(answer.at("outcome"), "bracketed");
    EXPECT_EQ(answer.at("reduce"), "joints");
    const double lower = answer.at("lower"), upper = answer.at("upper");
    EXPECT_LE(upper - lower, 0.01);
    EXPECT_LE(lower, 2.002);
    EXPECT_GE(upper, 1.998);
    EXPECT_EQ(answer.at("runs").at(0).at("factor"), 1.0);
    EXPECT_EQ(answer.at("runs").at(0).at("outcome"), "equilibrium");
    EXPECT_EQ(answer.at("mode").at("blocks").at(0).at("name"), "stone");
    EXPECT_EQ(answer.at("mode").at("blocks").at(0).at("movement"), "slides");
    EXPECT_EQ(answer.at("mode").at("joints").at(0).at("joint_material"), "joint");
    EXPECT_GT(answer.at("mode").at("joints").at(0).at("slip_m").get<double>(), 0.0);
}

/// A stone that its own friction does not hold has no bolt forces in equilibrium, with or without bolts.
TEST_F(SafetyCommand, FrozenForcesNeedAStandingScene) {
    putSlope();
    const Ended ended = keyblock({"safety", "slope.json", "--json", "--set", "safety.bolt_forces=frozen",
                                  "joint_materials.joint.friction_angle=20"});
    ASSERT_EQ(ended.code, 0) << ended.err;
    const json answer = json::parse(ended.out);
    EXPECT_EQ(answer.at("bolt_forces"), "frozen");
    EXPECT_EQ(answer.at("answer"), "undecided");
    EXPECT_EQ(answer.at("outcome"), "fails-at-1");
    EXPECT_TRUE(answer.at("factor").at("lower").is_null());
    EXPECT_EQ(answer.at("runs").size(), 1U);
    const Ended text = keyblock({"safety", "slope.json", "--overwrite", "--set", "safety.bolt_forces=frozen",
                                 "joint_materials.joint.friction_angle=20"});
    for (const char* part : {"bolt forces: frozen", "no bolt forces in equilibrium to freeze"})
        EXPECT_NE(text.out.find(part), std::string::npos) << part << "\n" << text.out;
}

TEST_F(SafetyCommand, RefusesFrozenForcesWhereBondsAreReduced) {
    putSlope();
    const Ended ended =
        keyblock({"safety", "slope.json", "--set", "safety.bolt_forces=frozen", "safety.reduce=both"});
    EXPECT_EQ(ended.code, 3);
    EXPECT_NE(ended.err.find("/safety/bolt_forces"), std::string::npos) << ended.err;
}

TEST_F(SafetyCommand, RefusesMotionWithItsPlace) {
    putEndlessScene();
    const Ended ended = keyblock({"safety", "rest.json"});
    EXPECT_EQ(ended.code, 3);
    EXPECT_TRUE(ended.out.empty()) << ended.out;
    EXPECT_EQ(lines(ended.err).size(), 1U) << ended.err;
    for (const char* part : {"rest.json:10", "/stages/0/kind", "dynamic"})
        EXPECT_NE(ended.err.find(part), std::string::npos) << part << "\n" << ended.err;
}

TEST_F(SafetyCommand, StandsHoweverWeak) {
    putSlope();
    const Ended ended = keyblock({"safety", "slope.json", "--json", "--set", "analysis.gravity=[0,-9]"});
    ASSERT_EQ(ended.code, 0) << ended.err;
    const json answer = json::parse(ended.out);
    EXPECT_EQ(answer.at("outcome"), "stands-at-1000");
    EXPECT_TRUE(answer.at("upper").is_null());
    EXPECT_TRUE(answer.at("mode").is_null());
}

TEST_F(SafetyCommand, ALimitOfTheSceneEndsTheSearch) {
    putSlope();
    const Ended ended = keyblock({"safety", "slope.json", "--json", "--set", "limits.steps=3", "stages[0].increments=10"});
    EXPECT_EQ(ended.code, 5) << ended.err;
    EXPECT_EQ(json::parse(ended.out).at("outcome"), "limit");
}

TEST_F(SafetyCommand, AnInterruptionLeavesTheBracketSoFar) {
    putPullScene();
    Program program({"safety", "pull.json", "--json", "--progress", "json", "--set", "stages[0].increments=100000",
                     "safety.reduce=bonds"},
                    folder());
    ASSERT_TRUE(waitFor([&] { return !program.errors().empty(); }));  // the search reports its progress
    program.signal(SIGINT);
    const Ended ended = program.wait();
    EXPECT_EQ(ended.code, 75) << ended.err;
    EXPECT_NE(ended.err.find("interrupted"), std::string::npos) << ended.err;
    EXPECT_EQ(json::parse(ended.out).at("outcome"), "stopped");
}

TEST_F(SafetyCommand, ProgressNamesTheFactor) {
    putSlope();
    const Ended ended = keyblock({"safety", "slope.json", "--progress", "json"});
    ASSERT_EQ(ended.code, 0) << ended.err;
    ASSERT_FALSE(lines(ended.err).empty());
    EXPECT_EQ(json::parse(lines(ended.err)[0]).at("stage"), "factor 1, rest");
}

}  // namespace
}  // namespace keyblock::test
