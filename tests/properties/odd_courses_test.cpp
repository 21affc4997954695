// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Odd courses of events: what is held, what acts, what the stages do, and how large
// and how far away all of it is. Each runs to the end that it must have; of most a
// property is known that needs no golden number.
#include "tests/properties/odd_scene.h"

#include "solver/run/run.h"

#include <gtest/gtest.h>

namespace keyblock {
namespace {

using namespace test;

void fallsFreely(const OddRun& run) {
    const Frame& end = run.results.frames.back();
    for (const BlockState& block : end.blocks)
        EXPECT_NEAR(block.displacement.y(), -0.5 * 9.81 * 0.01, 1e-9) << block.centroid.transpose();
}

void openingMonitorStands(const OddRun& run) {
    const auto at = [&](int stage) {
        double value = 0.0;
        for (const HistoryRow& row : run.results.history)
            if (row.stage == stage) value = row.values[1];
        return value;
    };
    EXPECT_EQ(at(1), at(0));
    EXPECT_EQ(at(2), at(0));
}

const Odd oddCourses[]{
    // supports, stress and gravity
    {"all_of_it_fixed", R"({"supports": [{"boundary": "all", "fix": "all"}], "joint_sets": [], "joints": [],
         "tunnels": [], "bolt_patterns": [], "stages": [{"name": "settle"}]})",
     "e", domainArea, nothingMoves},
    {"all_round_fixed", R"({"supports": [{"boundary": "all", "fix": "all"}], "joint_sets": [], "joints": []})", "eee",
     domainArea, nothingMoves},
    {"nothing_fixed", R"({"supports": []})", "ccc", domainArea, nullptr},
    {"nothing_fixed_in_motion", R"({"supports": [], "bolt_patterns": [], "in_situ_stress": null,
         "stages": [{"name": "fall", "kind": "dynamic", "duration": 0.1, "time_step": 0.01}]})",
     "d", domainArea - tunnelArea, fallsFreely},
    {"no_gravity", R"({"analysis": {"gravity": [0, 0]}})", "eee", domainArea, nullptr},
    {"no_gravity_and_no_stress", R"({"analysis": {"gravity": [0, 0]}, "in_situ_stress": null})", "eee", domainArea,
     nothingMoves},
    {"nothing_acts_and_nothing_holds", R"({"analysis": {"gravity": [0, 0]}, "in_situ_stress": null, "supports": []})",
     "eee", domainArea, nothingMoves},
    {"gravity_upwards", R"({"analysis": {"gravity": [0, 9.81]}, "in_situ_stress": null, "bolt_patterns": [],
         "stages": [{"name": "settle"}]})",
     "c", domainArea - tunnelArea, nullptr},
    {"tension_in_situ", R"({"in_situ_stress": {"sxx": 1e6, "syy": 1e6, "gradient_y": null}})", "eee", domainArea,
     [](const OddRun& run) { EXPECT_GT(largestMove(run.results.frames.back()), 1e-6); }},
    {"waves_out_of_a_fixed_side", R"({"supports": [{"boundary": "bottom", "fix": "all"}], "bolt_patterns": [],
         "tunnels": [], "stages": [{"name": "settle"},
         {"name": "rest", "kind": "dynamic", "duration": 0.01, "time_step": 0.001,
         "viscous_boundaries": ["bottom"]}]})",
     "ed", domainArea, nullptr},
    {"waves_out_of_all_sides_and_no_support", R"({"supports": [], "bolt_patterns": [], "tunnels": [],
         "stages": [{"name": "rest", "kind": "dynamic", "duration": 0.01, "time_step": 0.001,
                     "viscous_boundaries": ["all"]}]})",
     "d", domainArea, [](const OddRun& run) { EXPECT_LT(largestMove(run.results.frames.back()), 0.5 * 9.81 * 1e-4); }},
    {"no_friction", R"({"joint_materials": {"joint": {"friction_angle": 0}}})", "eee", domainArea, nullptr},
    {"a_millimetre_thick", R"({"analysis": {"thickness": 1e-3}, "bolt_patterns": [],
         "stages": [{"name": "settle"}, {"name": "excavate", "excavate": ["drift"], "increments": 10}]})",
     "ee", domainArea, nullptr},
    // stages
    {"stages_in_which_nothing_happens", R"({"stages": [{"name": "settle"}, {"name": "idle"}, {"name": "idle too"}]})",
     "eee", domainArea - tunnelArea, lastIsIdle},
    {"nothing_excavated", R"({"bolt_patterns": [], "stages": [{"name": "settle"}, {"name": "none", "excavate": []},
                                                     {"name": "release", "excavate": [], "relaxation": 0.5}]})",
     "eee", domainArea - tunnelArea,
     [](const OddRun& run) { EXPECT_TRUE(warns(run.reading, "nothing was excavated")); }},
    {"walls_held_wholly", R"({"bolt_patterns": [],
         "stages": [{"name": "settle"}, {"name": "excavate", "excavate": ["drift"], "relaxation": 0}]})",
     "ee", domainArea, nothingMoves},
    {"walls_let_go_wholly", R"({"bolt_patterns": [],
         "stages": [{"name": "settle"}, {"name": "excavate", "excavate": ["drift"], "relaxation": 1,
         "increments": 10}]})",
     "ee", domainArea, [](const OddRun& run) { EXPECT_GT(largestMove(run.results.frames.back()), 1e-7); }},
    {"walls_taken_back", R"({"bolt_patterns": [],
         "stages": [{"name": "settle"}, {"name": "excavate", "excavate": ["drift"], "relaxation": 0.8,
         "increments": 10},
                    {"name": "back", "relaxation": 0.2}]})",
     "eee", domainArea, lastIsIdle},
    {"load_on_what_goes_later", R"({"bolt_patterns": [],
         "stages": [{"name": "settle"}, {"name": "load", "loads": [{"point": [0, -0.5], "force": [0, -1e3]}]},
                    {"name": "excavate", "excavate": ["drift"], "increments": 10}]})",
     "eee", domainArea, nullptr},
    {"monitor_in_what_is_excavated", R"({"monitors": [{"name": "m", "point": [0, -0.5]}]})", "eee", domainArea,
     openingMonitorStands},
    {"stage_shorter_than_its_step", R"({"bolt_patterns": [],
         "stages": [{"name": "blink", "kind": "dynamic", "duration": 1e-9, "time_step": 1}]})",
     "d", domainArea - tunnelArea,
     [](const OddRun& run) { EXPECT_TRUE(warns(run.reading, "longer than the stage")); }},
    // places and sizes
    {"a_thousand_kilometres_away", R"({
         "domain": {"boundary": [[999996, 999997], [1000004, 999997], [1000004, 1000003], [999996, 1000003]]},
         "joints": [{"name": "level", "points": [[999996, 1000001.5], [1000004, 1000001.5]]}],
         "joint_sets": [{"name": "steep", "dip": 80, "spacing": 2.5, "origin": [1000000.3, 1000000]}],
         "tunnels": [{"name": "drift", "profile": "circle", "center": [1000000, 999999.5], "diameter": 2}],
         "bolt_patterns": [{"name": "roof", "type": "d-bolt-20", "tunnel": "drift", "from": [1000001, 1000000],
                            "to": [999999, 1000000], "spacing": 1, "length": 2.2, "divisions": 22}],
         "in_situ_stress": {"reference_y": 1000003}})",
     "eee", domainArea, asPlain},
    {"a_millimetre_wide", R"({
         "domain": {"boundary": [[-5e-4, -3.75e-4], [5e-4, -3.75e-4], [5e-4, 3.75e-4], [-5e-4, 3.75e-4]]},
         "joints": [{"name": "level", "points": [[-5e-4, 1.875e-4], [5e-4, 1.875e-4]]}],
         "joint_sets": [{"name": "steep", "dip": 80, "spacing": 3.125e-4, "origin": [3.75e-5, 0]}],
         "tunnels": [{"name": "drift", "profile": "circle", "center": [0, -6.25e-5], "diameter": 2.5e-4}],
         "bolt_patterns": [], "in_situ_stress": {"reference_y": 3.75e-4},
         "stages": [{"name": "settle"}, {"name": "excavate", "excavate": ["drift"], "increments": 10}]})",
     "ee", domainArea / 64e6, nullptr},
};

class OddCourse : public testing::TestWithParam<Odd> {};

TEST_P(OddCourse, ToTheEndThatItMustHave) { expectRuns(GetParam()); }

INSTANTIATE_TEST_SUITE_P(Odd, OddCourse, testing::ValuesIn(oddCourses),
                         [](const auto& scene) { return std::string(scene.param.name); });

TEST(OddScene, WithoutStagesIsCheckedAndNotRun) {
    const SceneReading reading = test::oddScene(R"({"stages": [], "bolt_patterns": []})");
    ASSERT_TRUE(reading.scene) << test::listing(reading);
    EXPECT_TRUE(warns(reading, "no stages"));
    EXPECT_TRUE(runInMemory(*reading.scene).stages.empty());
}

}  // namespace
}  // namespace keyblock
