// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Odd sections: tunnels, bolts, joints and domains that touch, coincide, stick out or
// miss. Each is cut without losing rock and runs to the end that it must have; of
// most a property is known that needs no golden number.
#include "tests/properties/odd_scene.h"

#include <gtest/gtest.h>

namespace keyblock {
namespace {

using namespace test;

void warnsOfNoBlock(const OddRun& run) {
    EXPECT_TRUE(warns(run.reading, "no block lies in the tunnel")) << test::listing(run.reading);
    EXPECT_LT(largestMove(run.results.frames.back()), 1e-4);
}

void holdsNoBolt(const OddRun& run) {
    EXPECT_TRUE(run.solved().bolts.empty());
    EXPECT_TRUE(warns(run.reading, "has no bolts"));
}

void boltIsFreeInTheOpening(const OddRun& run) {
    for (const BoltNodeFrame& node : run.results.frames.back().bolts.front().nodes) {
        const double away = (node.position - Point(0.0, -0.5)).norm();
        if (away < 0.95) {
            EXPECT_EQ(node.block, -1);
        }
        if (away > 1.05) {
            EXPECT_GE(node.block, 0);
        }
    }
}

void hasBlocks(const OddRun& run, std::size_t count) { EXPECT_EQ(run.solved().blocks.size(), count); }

/// Every bolt of a pattern is taken away again.
void noBoltIsLeft(const OddRun& run) {
    for (const BoltFrame& bolt : run.results.frames.back().bolts) EXPECT_TRUE(bolt.nodes.empty());
}

const Odd oddSections[]{
    {"plain", "{}", "eee", domainArea, asPlain},
    // tunnels
    {"tunnel_from_side_to_side",
     R"({"tunnels": [{"name": "drift", "profile": "polygon", "points": [[-4, -1], [4, -1], [4, 1], [-4, 1]]}],
         "bolt_patterns": [], "stages": [{"name": "settle"}, {"name": "excavate", "excavate": ["drift"]}]})",
     "ec", domainArea,
     [](const OddRun& run) {
         for (int block : run.results.stages[1].blocks)
             for (const Point& corner : run.solved().blocks[block].points)
                 EXPECT_GE(corner.y(), 1.0);  // the roof
     }},
    {"tunnel_touches_the_edge",
     R"({"tunnels": [{"name": "drift", "profile": "circle", "center": [-3, -0.5], "diameter": 2}], "bolt_patterns": [],
         "stages": [{"name": "settle"}, {"name": "excavate", "excavate": ["drift"]}]})",
     "ee", domainArea, nullptr},
    {"tunnel_side_on_the_edge",
     R"({"tunnels": [{"name": "drift", "profile": "polygon", "points": [[-4, -1], [-2, -1], [-2, 1], [-4, 1]]}],
         "bolt_patterns": [], "stages": [{"name": "settle"}, {"name": "excavate", "excavate": ["drift"]}]})",
     "ee", domainArea, nullptr},
    {"tunnel_outside",
     R"({"tunnels": [{"name": "drift", "profile": "circle", "center": [20, 0], "diameter": 2}], "bolt_patterns": [],
         "stages": [{"name": "settle"}, {"name": "excavate", "excavate": ["drift"], "relaxation": 0.5}]})",
     "ee", domainArea, warnsOfNoBlock},
    {"tunnel_below_the_tolerance",
     R"({"tunnels": [{"name": "drift", "profile": "circle", "center": [0, -0.5], "diameter": 1e-7}],
         "bolt_patterns": [], "stages": [{"name": "settle"}, {"name": "excavate", "excavate": ["drift"]}]})",
     "ee", domainArea, warnsOfNoBlock},
    {"tunnels_that_touch_at_a_point",
     R"({"tunnels": [{"name": "a", "profile": "circle", "center": [-1, -0.5], "diameter": 2},
                     {"name": "b", "profile": "circle", "center": [1, -0.5], "diameter": 2}], "bolt_patterns": [],
         "stages": [{"name": "settle"}, {"name": "first", "excavate": ["a"]}, {"name": "second", "excavate": ["b"]}]})",
     "eee", domainArea, nullptr},
    {"tunnels_that_share_a_wall",
     R"({"tunnels": [{"name": "a", "profile": "polygon", "points": [[-2, -1], [0, -1], [0, 1], [-2, 1]]},
                     {"name": "b", "profile": "polygon", "points": [[0, -1], [2, -1], [2, 1], [0, 1]]}],
         "bolt_patterns": [],
         "stages": [{"name": "settle"}, {"name": "first", "excavate": ["a"]}, {"name": "second", "excavate": ["b"]}]})",
     "eee", domainArea, nullptr},
    {"one_tunnel_by_two_names",
     R"({"tunnels": [{"name": "a", "profile": "circle", "center": [0, -0.5], "diameter": 2},
                     {"name": "b", "profile": "circle", "center": [0, -0.5], "diameter": 2}], "bolt_patterns": [],
         "stages": [{"name": "settle"}, {"name": "first", "excavate": ["a"]}, {"name": "second", "excavate": ["b"]}]})",
     "eee", domainArea, lastIsIdle},
    {"pilot_and_then_its_drift",
     R"({"tunnels": [{"name": "a", "profile": "circle", "center": [0, -0.5], "diameter": 1},
                     {"name": "b", "profile": "circle", "center": [0, -0.5], "diameter": 3}], "bolt_patterns": [],
         "stages": [{"name": "settle"}, {"name": "first", "excavate": ["a"]}, {"name": "second", "excavate": ["b"]}]})",
     "eee", domainArea, nullptr},
    {"drift_and_then_its_pilot",
     R"({"tunnels": [{"name": "a", "profile": "circle", "center": [0, -0.5], "diameter": 1},
                     {"name": "b", "profile": "circle", "center": [0, -0.5], "diameter": 3}], "bolt_patterns": [],
         "stages": [{"name": "settle"}, {"name": "first", "excavate": ["b"]}, {"name": "second", "excavate": ["a"]}]})",
     "eee", domainArea, lastIsIdle},
    {"hole_in_an_open_hole",
     R"({"tunnels": [{"name": "a", "profile": "circle", "center": [0, -0.5], "diameter": 1},
                     {"name": "b", "profile": "circle", "center": [0, -0.5], "diameter": 2}], "bolt_patterns": [],
         "stages": [{"name": "excavate", "excavate": ["a"]}]})",
     "e", domainArea - tunnelArea, warnsOfNoBlock},
    // bolts
    {"pattern_sparser_than_its_wall", R"({"bolt_patterns": [{"name": "roof", "type": "d-bolt-20", "tunnel": "drift",
         "from": [1, 0], "to": [-1, 0], "spacing": 100, "length": 2.2}]})",
     "eee", domainArea, [](const OddRun& run) { EXPECT_EQ(run.solved().bolts.size(), 1u); }},
    {"pattern_that_begins_beyond_its_end", R"({"bolt_patterns": [{"name": "roof", "type": "d-bolt-20",
         "tunnel": "drift", "from": [1, 0], "to": [-1, 0], "spacing": 1, "offset": 50, "length": 2.2}]})",
     "eee", domainArea, holdsNoBolt},
    {"bolts_longer_than_the_rock", R"({"bolt_patterns": [{"name": "roof", "type": "rebar-20", "tunnel": "drift",
         "from": [1, 0], "to": [-1, 0], "spacing": 1, "length": 4.5, "divisions": 45}]})",
     "eee", domainArea, nullptr},
    {"bolt_through_a_corner", R"({"joint_sets": [], "joints": [{"name": "level", "points": [[-4, 1.5], [4, 1.5]]},
                                            {"name": "upright", "points": [[0, 3], [0, 1.5]]}],
         "bolts": [{"name": "B", "type": "rebar-20", "far_end": [1, 2.5], "head": [-1, 0.5], "divisions": 20}]})",
     "eee", domainArea, nullptr},
    {"bolt_across_the_opening", R"({"bolt_patterns": [],
         "bolts": [{"name": "B", "type": "rebar-20", "far_end": [-2.5, -0.45], "head": [2.5, -0.55], "divisions": 30}],
         "stages": [{"name": "settle"}, {"name": "excavate", "excavate": ["drift"]}, {"name": "bolt",
         "install": ["B"]}]})",
     "eee", domainArea, boltIsFreeInTheOpening},
    {"bolt_that_is_dug_free", R"({"bolt_patterns": [],
         "bolts": [{"name": "B", "type": "rebar-20", "far_end": [-2.5, -0.45], "head": [2.5, -0.55], "divisions": 30}],
         "stages": [{"name": "settle"}, {"name": "excavate", "excavate": ["drift"]}]})",
     "ee", domainArea, boltIsFreeInTheOpening},
    {"bolt_out_of_both_sides", R"({"bolt_patterns": [], "tunnels": [], "stages": [{"name": "settle"}],
         "bolts": [{"name": "B", "type": "rebar-20", "far_end": [-6, 0.45], "head": [6, 0.55], "divisions": 30}]})",
     "e", domainArea, [](const OddRun& run) { EXPECT_TRUE(warns(run.reading, "is not on rock")); }},
    {"bolts_removed_that_none_installed", R"({"stages": [{"name": "settle"},
         {"name": "excavate", "excavate": ["drift"], "increments": 5}, {"name": "remove", "remove": ["roof"]}]})",
     "eee", domainArea, noBoltIsLeft},
    // joints and cells
    {"joint_on_the_wall",
     R"({"tunnels": [{"name": "drift", "profile": "polygon", "points": [[-1, -1], [1, -1], [1, 1], [-1, 1]]}],
         "joints": [{"name": "level", "points": [[-4, 1], [4, 1]]}]})",
     "eee", domainArea, [](const OddRun& run) { EXPECT_TRUE(notes(run.reading, CutNoteKind::MergedTrace)); }},
    {"joint_on_the_boundary", R"({"joints": [{"name": "level", "points": [[-4, 3], [4, 3]]}]})", "eee", domainArea,
     [](const OddRun& run) { hasBlocks(run, 6); }},
    {"joint_of_no_length", R"({"joints": [{"name": "level", "points": [[-1, 1.5], [-1, 1.5]]}]})", "eee", domainArea,
     [](const OddRun& run) {
         hasBlocks(run, 6);
         EXPECT_TRUE(notes(run.reading, CutNoteKind::DroppedShort));
     }},
    {"joint_with_a_point_twice",
     R"({"joints": [{"name": "level", "points": [[-4, 1.5], [0, 1.5], [0, 1.5], [4, 1.5]]}]})",
     "eee", domainArea, asPlain},
    {"joint_given_twice", R"({"joints": [{"name": "level", "points": [[-4, 1.5], [4, 1.5]]},
                                         {"name": "again", "points": [[4, 1.5], [-4, 1.5]]}]})",
     "eee", domainArea,
     [](const OddRun& run) {
         asPlain(run);
         EXPECT_TRUE(notes(run.reading, CutNoteKind::MergedTrace));
     }},
    {"joint_given_nearly_twice", R"({"joints": [{"name": "level", "points": [[-4, 1.5], [4, 1.5]]},
                                                {"name": "again", "points": [[-4, 1.5000001], [4, 1.4999999]]}]})",
     "eee", domainArea, asPlain},
    {"joint_that_ends_in_rock", R"({"joints": [{"name": "level", "points": [[-3, 1.5], [-2.5, 1.5]]}]})", "eee",
     domainArea,
     [](const OddRun& run) {
         hasBlocks(run, 6);
         EXPECT_TRUE(notes(run.reading, CutNoteKind::DroppedLoose));
     }},
    {"joint_outside", R"({"joints": [{"name": "level", "points": [[-30, 1.5], [-25, 1.5]]}]})", "eee", domainArea,
     [](const OddRun& run) {
         hasBlocks(run, 6);
         EXPECT_TRUE(notes(run.reading, CutNoteKind::DroppedOutside));
     }},
    {"joint_that_crosses_itself",
     R"({"joints": [{"name": "level", "points": [[-4, 1.5], [4, 1.5], [2, 2.8], [2, -2.8]]}]})",
     "eee", domainArea, [](const OddRun& run) { EXPECT_GT(run.solved().blocks.size(), 10u); }},
    {"joint_set_wider_than_the_domain",
     R"({"joint_sets": [{"name": "steep", "dip": 80, "spacing": 1000, "origin": [0.3, 0]}]})",
     "eee", domainArea, nullptr},
    {"joint_set_that_misses_the_domain",
     R"({"joint_sets": [{"name": "steep", "dip": 80, "spacing": 1000, "origin": [300, 0]}]})",
     "eee", domainArea, [](const OddRun& run) { hasBlocks(run, 4); }},
    {"joint_sets_that_coincide", R"({"joint_sets": [{"name": "steep", "dip": 80, "spacing": 2.5, "origin": [0.3, 0]},
                                                    {"name": "again", "dip": -100, "spacing": 2.5, "origin": [0.3,
         0]}]})",
     "eee", domainArea, asPlain},
    {"joint_set_in_a_region_outside", R"({"joint_sets": [{"name": "steep", "dip": 80, "spacing": 1, "region": "r"}],
         "regions": [{"name": "r", "points": [[20, 20], [25, 20], [25, 25]]}]})",
     "eee", domainArea, [](const OddRun& run) { hasBlocks(run, 4); }},
    {"voronoi_of_one_cell", R"({"voronoi": {"size": 100}, "joints": [], "joint_sets": []})", "eee", domainArea,
     [](const OddRun& run) { hasBlocks(run, 3); }},
    {"dilation_of_a_joint_that_another_covers",
     R"({"joints": [{"name": "level", "points": [[-4, 1.5], [4, 1.5]]}, {"name": "again", "points": [[-4, 1.5], [4,
         1.5]]}],
         "bolt_patterns": [],
         "stages": [{"name": "settle"}, {"name": "open", "dilations": [{"joint": "again", "rate": 1e-3}],
         "increments": 5}]})",
     "ee", domainArea - tunnelArea,
     [](const OddRun& run) {
         EXPECT_TRUE(warns(run.reading, "nothing opens"));
         lastIsIdle(run);
     }},
    // domains
    {"domain_drawn_clockwise", R"({"domain": {"boundary": [[-4, 3], [4, 3], [4, -3], [-4, -3]]}})", "eee", domainArea,
     asPlain},
    {"domain_with_a_corner_on_an_edge", R"({"domain": {"boundary": [[-4, -3], [0, -3], [4, -3], [4, 3], [-4, 3]]}})",
     "eee", domainArea, asPlain},
    {"domain_of_two_parts_that_touch", R"({"domain": {"boundary": [[-4, -3], [4, -3], [4, 3], [0, -3], [-4, 3]]},
         "joint_sets": [], "joints": [], "tunnels": [], "bolt_patterns": [], "stages": [{"name": "settle"}],
         "supports": [{"boundary": "bottom", "fix": "xy"}], "in_situ_stress": null})",
     "e", 24.0, [](const OddRun& run) { hasBlocks(run, 2); }},
    {"domain_that_is_a_sliver", R"({"domain": {"boundary": [[-4, -3], [4, -3], [4, -2.999]]}, "joints": [],
         "joint_sets": [], "tunnels": [], "bolt_patterns": [], "stages": [{"name": "settle"}],
         "supports": [{"boundary": "bottom", "fix": "xy"}], "in_situ_stress": null})",
     "e", 0.004, nullptr},
    {"three_sets_through_the_same_points", R"({"joints": [],
         "joint_sets": [{"name": "level", "dip": 0, "spacing": 1.25, "origin": [0.2, 0.3]},
                        {"name": "rising", "dip": 60, "spacing": 1.25, "origin": [0.2, 0.3]},
                        {"name": "falling", "dip": -60, "spacing": 1.25, "origin": [0.2, 0.3]}],
         "joint_materials": {"joint": {"friction_angle": 60}}, "bolt_patterns": [],
         "stages": [{"name": "settle"}, {"name": "excavate", "excavate": ["drift"], "relaxation": 0}]})",
     "ee", domainArea, nothingMoves},
};

class OddSection : public testing::TestWithParam<Odd> {};

TEST_P(OddSection, ToTheEndThatItMustHave) { expectRuns(GetParam()); }

INSTANTIATE_TEST_SUITE_P(Odd, OddSection, testing::ValuesIn(oddSections),
                         [](const auto& scene) { return std::string(scene.param.name); });

}  // namespace
}  // namespace keyblock
