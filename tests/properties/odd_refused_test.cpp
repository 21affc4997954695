// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Odd scenes that mean nothing: each is refused once, at its place, with a word of
// what to do.
#include "tests/properties/odd_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>

namespace keyblock {
namespace {

struct Refused {
    const char* name;
    const char* patch;
    const char* pointer;
    const char* word;  // of message or remedy
};

void PrintTo(const Refused& scene, std::ostream* out) { *out << scene.name; }

constexpr Refused refused[]{
    {"tunnel_wider_than_the_domain",
     R"({"tunnels": [{"name": "drift", "profile": "circle", "center": [0, 0], "diameter": 20}], "bolt_patterns": [],
         "stages": [{"name": "settle"}, {"name": "excavate", "excavate": ["drift"]}]})",
     "/stages/1/excavate", "Make the tunnel smaller"},
    {"open_tunnel_wider_than_the_domain",
     R"({"tunnels": [{"name": "drift", "profile": "circle", "center": [0, 0], "diameter": 20}], "bolt_patterns": [],
         "supports": [], "stages": [{"name": "settle"}]})",
     "/blocks", "outside the open tunnels"},
    {"all_blocks_excavated_by_name",
     R"({"joints": [], "joint_sets": [], "tunnels": [], "bolt_patterns": [],
         "stages": [{"name": "settle"}, {"name": "excavate", "excavate": ["b1"]}]})",
     "/stages/1/excavate", "no block is left"},
    {"all_blocks_merged_into_the_tunnel",
     R"({"cutting": {"min_area": 1000}, "bolt_patterns": [], "stages": [{"name": "excavate", "excavate": ["drift"]}]})",
     "/stages/0/excavate", "no block is left"},
    {"tunnel_that_is_a_bow_tie",
     R"({"tunnels": [{"name": "drift", "profile": "polygon", "points": [[-1, -1], [1, 1], [1, -1], [-1, 1]]}]})",
     "/tunnels/0/points", "split it in two"},
    {"tunnel_of_no_size", R"({"tunnels": [{"name": "drift", "profile": "circle", "center": [0, 0], "diameter": 0}]})",
     "/tunnels/0/diameter", "Give metres"},
    {"pattern_of_a_tunnel_that_is_not_there",
     R"({"bolt_patterns": [{"name": "roof", "type": "d-bolt-20", "tunnel": "shaft", "from": [1, 0], "to": [-1, 0],
                            "spacing": 1, "length": 2.2}]})",
     "/bolt_patterns/0/tunnel", "Available: 'drift'"},
    {"bolt_outside",
     R"({"bolts": [{"name": "B", "type": "d-bolt-20", "far_end": [10, 10], "head": [12, 10], "divisions": 9}]})",
     "/bolts/0", "Move it into the rock"},
    {"bolt_along_a_joint",
     R"({"bolts": [{"name": "B", "type": "rebar-20", "far_end": [-3, 1.5], "head": [3, 1.5], "divisions": 9}]})",
     "/bolts/0", "Move or turn it"},
    {"bolt_in_an_open_tunnel",
     R"({"bolt_patterns": [], "stages": [{"name": "settle"}],
         "bolts": [{"name": "B", "type": "rebar-20", "far_end": [-0.5, -0.5], "head": [0.5, -0.5], "divisions": 9}]})",
     "/bolts/0", "Move it into the rock"},
    {"bolt_installed_in_rock_that_is_gone",
     R"({"bolt_patterns": [],
         "bolts": [{"name": "B", "type": "rebar-20", "far_end": [-0.5, -0.5], "head": [0.5, -0.5], "divisions": 9}],
         "stages": [{"name": "settle"}, {"name": "excavate", "excavate": ["drift"]},
                    {"name": "bolt", "install": ["B"]}]})",
     "/stages/2/install/0", "Install it in an earlier stage"},
    {"joint_twice_by_name",
     R"({"joints": [{"name": "level", "points": [[-4, 1.5], [4, 1.5]]}, {"name": "level", "points": [[-4, 1], [4,
         1]]}]})",
     "/joints/1/name", "its own name"},
    {"joint_set_beyond_the_limit", R"({"joint_sets": [{"name": "steep", "dip": 80, "spacing": 1e-5}]})",
     "/joint_sets/0/spacing", "larger spacing"},
    {"cells_beyond_the_limit", R"({"voronoi": {"size": 0.001}})", "/voronoi/size", "larger size"},
    {"region_without_area", R"({"regions": [{"name": "r", "points": [[0, 0], [1, 0], [2, 0]]}]})", "/regions/0/points",
     "one line"},
    {"domain_without_area", R"({"domain": {"boundary": [[-4, -3], [4, -3], [0, -3]]}})", "/domain/boundary",
     "one line"},
    {"domain_that_is_a_bow_tie", R"({"domain": {"boundary": [[-4, -3], [4, 3], [4, -3], [-4, 3]]}})",
     "/domain/boundary", "split it in two"},
    {"block_in_a_tunnel_that_is_excavated_later",
     R"({"bolt_patterns": [], "stages": [{"name": "settle"}, {"name": "excavate", "excavate": ["drift"]}],
         "blocks": [{"points": [[-0.3, -1.4], [0.3, -1.4], [0.3, -1], [-0.3, -1]], "material": "rock"}]})",
     "/blocks/0", "out of the domain"},
    {"pattern_installed_twice",
     R"({"stages": [{"name": "settle"}, {"name": "bolt", "install": ["roof"]}, {"name": "again",
         "install": ["roof"]}]})",
     "/stages/2/install/0", "Name it only once"},
    {"pattern_and_a_bolt_of_it_installed",
     R"({"stages": [{"name": "settle"}, {"name": "bolt", "install": ["roof", "roof.1"]}]})", "/stages/1/install/1",
     "Name it only once"},
    {"bolt_removed_twice",
     R"({"stages": [{"name": "bolt", "install": ["roof"]}, {"name": "remove", "remove": ["roof"]},
                    {"name": "again", "remove": ["roof.1"]}]})",
     "/stages/2/remove/0", "Name it only once"},
    {"pattern_installed_and_removed_at_once",
     R"({"stages": [{"name": "settle"}, {"name": "bolt", "install": ["roof"], "remove": ["roof"]}]})",
     "/stages/1/remove/0", "after the stage that installs it"},
    {"pattern_installed_after_its_removal",
     R"({"stages": [{"name": "settle"}, {"name": "remove", "remove": ["roof"]}, {"name": "bolt",
         "install": ["roof"]}]})",
     "/stages/1/remove/0", "after the stage that installs it"},
    {"monitor_in_the_opening",
     R"({"bolt_patterns": [], "stages": [{"name": "settle"}], "monitors": [{"name": "m", "point": [0, -0.5]}]})",
     "/monitors/0/point", "inside a block"},
    {"load_in_the_air",
     R"({"stages": [{"name": "settle"}, {"name": "load", "loads": [{"point": [0, 20], "force": [0, -1e3]}]}]})",
     "/stages/1/loads/0/point", "inside a block"},
    {"load_in_the_opening",
     R"({"stages": [{"name": "excavate", "excavate": ["drift"]},
                    {"name": "load", "loads": [{"point": [0, -0.5], "force": [0, -1e3]}]}]})",
     "/stages/1/loads/0/point", "still there"},
    {"speed_of_what_is_excavated",
     R"({"stages": [{"name": "excavate", "excavate": ["drift"]},
                    {"name": "throw", "kind": "dynamic", "duration": 0.01,
                     "initial_velocities": [{"block_at": [0, -0.5], "velocity": [0, 1]}]}]})",
     "/stages/1/initial_velocities/0/block_at", "still there"},
    {"waves_out_of_no_side",
     R"({"stages": [{"name": "shake", "kind": "dynamic", "duration": 0.01, "viscous_boundaries": ["up"]}]})",
     "/stages/0/viscous_boundaries/0", "Did you mean 'top'?"},
    {"dilation_of_an_unknown_joint",
     R"({"stages": [{"name": "open", "dilations": [{"joint": "fault", "rate": 1e-3}]}]})",
     "/stages/0/dilations/0/joint", "Available: 'level', 'steep'"},
    {"support_of_a_side_that_is_excavated_away",
     R"({"supports": [{"boundary": "left", "fix": "x"}], "bolt_patterns": [], "stages": [{"name": "settle"}],
         "tunnels": [{"name": "drift", "profile": "polygon", "points": [[-4, -3], [-2, -3], [-2, 3], [-4, 3]]}]})",
     "/supports/0/boundary", "Give another side"},
};

class OddSceneRefused : public testing::TestWithParam<Refused> {};

TEST_P(OddSceneRefused, OnceAtItsPlaceWithARemedy) {
    const SceneReading reading = test::oddScene(GetParam().patch);
    EXPECT_FALSE(reading.scene);
    const auto isError = [](const Problem& problem) { return problem.severity == Severity::Error; };
    ASSERT_EQ(std::count_if(reading.problems.begin(), reading.problems.end(), isError), 1) << test::listing(reading);
    const Problem& error = *std::find_if(reading.problems.begin(), reading.problems.end(), isError);
    EXPECT_EQ(error.pointer, GetParam().pointer) << test::listing(reading);
    EXPECT_NE((error.message + ". " + error.remedy).find(GetParam().word), std::string::npos) << test::listing(reading);
    EXPECT_FALSE(error.remedy.empty());
}

INSTANTIATE_TEST_SUITE_P(Odd, OddSceneRefused, testing::ValuesIn(refused),
                         [](const auto& scene) { return std::string(scene.param.name); });

}  // namespace
}  // namespace keyblock
