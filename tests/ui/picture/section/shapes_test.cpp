// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Positions: clipping at the frame, room for labels, marks at minimum distances.
#include "ui/picture/section/clip_to_box.h"
#include "ui/picture/section/marks.h"
#include "ui/picture/section/placement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace keyblock {
namespace {

const Box unit{{0.0, 0.0}, {1.0, 1.0}};

TEST(ClipToBox, KeepsTheAreaInside) {
    EXPECT_NEAR(std::abs(signedArea(clippedToBox({{-1, -1}, {0.5, -1}, {0.5, 0.5}, {-1, 0.5}}, unit))), 0.25, 1e-15);
    EXPECT_NEAR(std::abs(signedArea(clippedToBox({{-9, -9}, {9, -9}, {9, 9}, {-9, 9}}, unit))), 1.0, 1e-15);
    EXPECT_TRUE(clippedToBox({{2, 2}, {3, 2}, {3, 3}}, unit).empty());
}

TEST(ClipToBox, CutsSegments) {
    const auto part = clippedToBox({-1.0, 0.5}, {2.0, 0.5}, unit);
    ASSERT_TRUE(part);
    EXPECT_NEAR(part->first.x(), 0.0, 1e-15);
    EXPECT_NEAR(part->second.x(), 1.0, 1e-15);
    EXPECT_FALSE(clippedToBox({-1.0, 1.5}, {2.0, 1.5}, unit));
    EXPECT_FALSE(clippedToBox({-1.0, 0.5}, {-0.1, 0.5}, unit));
}

TEST(Placement, LabelsDoNotOverlap) {
    const Box frame{{0, 0}, {50, 50}};
    Placement placement(frame);
    placement.keepOff(Point(0, 25), Point(50, 25), 1.0);
    std::vector<Box> placed;
    for (int i = 0; i < 200; ++i)
        if (const auto box = placement.placeRound({4, 3}, {25, 20}, {0, -1})) placed.push_back(*box);
    EXPECT_GE(placed.size(), 5u);  // earlier labels block leaders
    for (std::size_t i = 0; i < placed.size(); ++i) {
        EXPECT_GE(placed[i].min.x(), 0.0);
        EXPECT_LE(placed[i].max.y(), 24.0);  // leaders cross no line either
        for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(meets(placed[i], placed[j]));
    }
}

TEST(Placement, LabelsWithoutRoomAreReported) {
    Placement placement({{0, 0}, {10, 10}});
    placement.keepOff(Box{{0, 0}, {10, 10}});
    EXPECT_FALSE(placement.place({1, 1}, {{5, 5}, {2, 2}}));
    EXPECT_FALSE(placement.placeRound({1, 1}, {5, 5}, {1, 0}));
}

std::vector<Mark> marksAlong(MarkKind kind, double from, double step, int count) {
    std::vector<Mark> marks;
    for (int i = 0; i < count; ++i) marks.push_back({kind, from + i * step, {0.0, 0.0}, {1.0, 0.0}});
    return marks;
}

std::size_t countOf(const std::vector<Mark>& marks, MarkKind kind) {
    return 
        std::count_if(marks.begin(), marks.end(), [&](const Mark& mark) { return mark.kind == kind; });
}

TEST(Marks, BondedMarksKeepTheirDistance) {
    const auto kept = thinned(marksAlong(MarkKind::Bonded, 0.0, 0.03, 60), 0.1);
    EXPECT_EQ(kept.size(), 15u);  // every fourth
    for (std::size_t i = 0; i < kept.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) EXPECT_GE(std::abs(kept[i].s - kept[j].s), 0.1);
}

TEST(Marks, FailedMarksAreNeverDropped) {
    auto marks = marksAlong(MarkKind::Bonded, 0.0, 0.1, 10);
    marks.push_back({MarkKind::Gone, 0.31, {0.0, 0.0}, {1.0, 0.0}});
    marks.push_back({MarkKind::Yielded, 0.315, {0.0, 0.0}, {1.0, 0.0}});
    marks.push_back({MarkKind::Ruptured, 0.32, {0.0, 0.0}, {1.0, 0.0}});
    const auto kept = thinned(marks, 0.09);
    EXPECT_EQ(countOf(kept, MarkKind::Gone), 1u);
    EXPECT_EQ(countOf(kept, MarkKind::Yielded), 1u);
    EXPECT_EQ(countOf(kept, MarkKind::Ruptured), 1u);
    EXPECT_EQ(countOf(kept, MarkKind::Bonded), 8u);  // those at 0.3 and 0.4 are dropped
}

TEST(Marks, AnIntermediatePointIsNeverFailed) {
    Bolt bolt;
    bolt.head = {1.0, 0.0};
    BoltFrame frame;
    for (int i = 0; i < 3; ++i) {
        BoltNodeFrame node;
        node.s = 0.5 * i;
        node.block = i == 1 ? -1 : 0;
        node.state = NodeState::Gone;
        node.real = i == 2;
        frame.nodes.push_back(node);
    }
    frame.plateHolds = true;
    const auto marks = marksOf(bolt, 0, frame, {{0, 0}, {0.5, 0}, {1, 0}}, {});
    EXPECT_EQ(countOf(marks, MarkKind::Artificial), 1u);
    EXPECT_EQ(countOf(marks, MarkKind::InGap), 1u);
    EXPECT_EQ(countOf(marks, MarkKind::Gone), 1u);
    EXPECT_EQ(countOf(marks, MarkKind::Plate), 1u);
}

}  // namespace
}  // namespace keyblock
