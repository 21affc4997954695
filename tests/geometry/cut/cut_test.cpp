// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cuts whose blocks are known: how many, how large, with which corners, and what
// is informed of what was closed, trimmed, merged or left out.
#include "geometry/cut/cut.h"

#include "geometry/polygon.h"
#include "tests/geometry/cut/cut_property.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <random>

namespace keyblock {
namespace {

using Outline = std::vector<Point>;

Outline rectangle(double left, double bottom, double right, double top) {
    return {{left, bottom}, {right, bottom}, {right, top}, {left, top}};
}

/// A square of 2 m about the origin.
CutInput squareInput() {
    CutInput input;
    input.domains = {{1, rectangle(-1, -1, 1, 1)}};
    return input;
}

Outline circle(const Point& centre, double radius, int corners, double first = 0.0) {
    Outline outline;
    for (int i = 0; i < corners; ++i) {
        const double angle = first + 2.0 * std::numbers::pi * i / corners;
        outline.push_back(centre + radius * Point(std::cos(angle), std::sin(angle)));
    }
    return outline;
}

void addClosed(CutInput& input, const Outline& outline, int source) {
    for (std::size_t i = 0; i < outline.size(); ++i)
        input.traces.push_back({outline[i], outline[(i + 1) % outline.size()], source});
}

std::vector<double> areas(const Cut& cut) {
    std::vector<double> found;
    for (const CutBlock& block : cut.blocks) found.push_back(block.area);
    std::sort(found.begin(), found.end());
    return found;
}

void expectAreas(const Cut& cut, std::vector<double> expected) {
    std::sort(expected.begin(), expected.end());
    const std::vector<double> found = areas(cut);
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], 1e-12 * expected.back());
}

std::vector<CutNote> notesOf(const Cut& cut, CutNoteKind kind) {
    std::vector<CutNote> found;
    for (const CutNote& note : cut.notes)
        if (note.kind == kind) found.push_back(note);
    return found;
}

/// The block whose outer ring has `p` inside.
const CutBlock* blockAt(const Cut& cut, const Point& p) {
    const auto holds = [&](const CutRing& ring) { return locate(outlineOf(cut, ring), p, 0.0) == Side::Inside; };
    for (const CutBlock& block : cut.blocks)
        if (holds(block.outer) && std::none_of(block.holes.begin(), block.holes.end(), holds)) return &block;
    return nullptr;
}

TEST(Cut, WithoutTracesADomainIsABlock) {
    const Cut cut = cutIntoBlocks(squareInput());
    ASSERT_EQ(cut.blocks.size(), 1u);
    EXPECT_EQ(outlineOf(cut, cut.blocks[0].outer), rectangle(-1, -1, 1, 1));
    EXPECT_EQ(cut.blocks[0].outer.sources, std::vector<int>(4, borderSource));
    EXPECT_DOUBLE_EQ(cut.blocks[0].width, 1.0);  // 2·4 / 8
    EXPECT_TRUE(cut.notes.empty());
    EXPECT_DOUBLE_EQ(cut.tolerance, 2e-6);
    EXPECT_DOUBLE_EQ(cut.minArea, 4e-3);  // 1e-3 of the mean face
    EXPECT_DOUBLE_EQ(cut.minWidth, 2e-2);
}

TEST(Cut, ACrossGivesFourEqualBlocks) {
    CutInput input = squareInput();
    input.traces = {{{-2, 0}, {2, 0}, 5}, {{0, -1}, {0, 1}, 7}};
    const Cut cut = cutIntoBlocks(input);
    expectAreas(cut, {1, 1, 1, 1});
    EXPECT_EQ(cut.vertices.size(), 9u);
    EXPECT_EQ(outlineOf(cut, cut.blocks[0].outer), rectangle(-1, -1, 0, 0));
    EXPECT_EQ(cut.blocks[0].outer.sources, (std::vector<int>{borderSource, 7, 5, borderSource}));
    EXPECT_TRUE(cut.notes.empty());
}

TEST(Cut, AGridWithRandomOffsetsHasTheProductsAsAreas) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> offset(-0.2, 0.2);
    CutInput input;
    input.domains = {{1, rectangle(0, 0, 12, 9)}};
    std::vector<double> xs{0}, ys{0}, expected;
    for (int i = 1; i < 12; ++i) {
        const double x = xs.emplace_back(i + offset(random));
        input.traces.push_back({{x, -1}, {x, 10}, 1});
    }
    for (int i = 1; i < 9; ++i) {
        const double y = ys.emplace_back(i + offset(random));
        input.traces.push_back({{-1, y}, {13, y}, 2});
    }
    xs.push_back(12);
    ys.push_back(9);
    for (std::size_t i = 1; i < xs.size(); ++i)
        for (std::size_t j = 1; j < ys.size(); ++j) expected.push_back((xs[i] - xs[i - 1]) * (ys[j] - ys[j - 1]));
    expectAreas(cutIntoBlocks(input), expected);
    EXPECT_EQ(brokenCut(input), "");
}

TEST(Cut, ACircleWithoutJointsIsADiscInABlockWithAHole) {
    CutInput input = squareInput();
    const Outline outline = circle({0.1, 0.2}, 0.5, 40);
    addClosed(input, outline, 4);
    const Cut cut = cutIntoBlocks(input);
    const double disc = 0.5 * 40 * 0.25 * std::sin(2.0 * std::numbers::pi / 40);
    expectAreas(cut, {disc, 4.0 - disc});
    const CutBlock& around = cut.blocks[0];
    ASSERT_EQ(around.holes.size(), 1u);
    EXPECT_EQ(around.holes[0].vertices.size(), 40u);
    EXPECT_EQ(around.holes[0].sources, std::vector<int>(40, 4));
    EXPECT_LT(signedArea(outlineOf(cut, around.holes[0])), 0.0);
    EXPECT_EQ(cut.blocks[1].outer.vertices.size(), 40u);
    EXPECT_EQ(cut.blocks[1].outer.vertices.front(), around.holes[0].vertices.front());
    EXPECT_TRUE(cut.notes.empty());
    EXPECT_EQ(brokenCut(input), "");
}

TEST(Cut, ACornerOfTracesLeavesAConcaveBlock) {
    CutInput input = squareInput();
    input.traces = {{{0, -1}, {0, 0}, 1}, {{0, 0}, {1, 0}, 1}};
    const Cut cut = cutIntoBlocks(input);
    expectAreas(cut, {1, 3});
    EXPECT_EQ(outlineOf(cut, cut.blocks[0].outer), (Outline{{-1, -1}, {0, -1}, {0, 0}, {1, 0}, {1, 1}, {-1, 1}}));
}

TEST(Cut, WhereANeighboursEdgeEndsABlockHasNoVertexUnlessAskedFor) {
    CutInput input = squareInput();
    input.traces = {{{-1, 0}, {1, 0}, 1}, {{0.25, -1}, {0.25, 0}, 2}};
    EXPECT_EQ(blockAt(cutIntoBlocks(input), {0, 0.5})->outer.vertices.size(), 4u);
    input.settings.keepStraight = true;
    EXPECT_EQ(blockAt(cutIntoBlocks(input), {0, 0.5})->outer.vertices.size(), 5u);
}

TEST(Cut, AnEndIsPulledOverWhatItReachesWithinTheTolerance) {
    for (double gap : {-0.9e-3, -1e-9, 0.0, 1e-9, 0.9e-3, 1.1e-3}) {
        CutInput input = squareInput();
        input.settings.tolerance = 1e-3;
        input.traces = {{{-1, 0}, {1, 0}, 1}, {{0.25, -1}, {0.25, -gap}, 2}};
        const Cut cut = cutIntoBlocks(input);
        if (gap < 1e-3) {
            expectAreas(cut, {2, 1.25, 0.75});
            EXPECT_EQ(notesOf(cut, CutNoteKind::PulledEnd).size(), gap == 0.9e-3 ? 1u : 0u) << gap;
        } else {
            expectAreas(cut, {2, 2});
            ASSERT_EQ(cut.notes.size(), 1u);
            EXPECT_EQ(cut.notes[0].kind, CutNoteKind::DroppedLoose);
            EXPECT_NEAR(cut.notes[0].measure, 1.0 - gap, 1e-12);
        }
    }
}

TEST(Cut, AnEndIsPulledOverTheBorder) {
    for (double gap : {0.9e-3, 1.1e-3}) {
        CutInput input = squareInput();
        input.settings.tolerance = 1e-3;
        input.traces = {{{-1 + gap, 0.5}, {1, 0.25}, 1}};
        const Cut cut = cutIntoBlocks(input);
        EXPECT_EQ(cut.blocks.size(), gap < 1e-3 ? 2u : 1u);
        for (const Point& p : cut.vertices) EXPECT_LE(p.cwiseAbs().maxCoeff(), 1.0);
    }
}

TEST(Cut, AShallowEndReachesItsTargetSideways) {
    CutInput input = squareInput();
    input.settings.tolerance = 1e-3;
    input.traces = {{{-1, 0}, {1, 0}, 1}, {{-1, -0.1}, {0, -0.9e-3}, 2}};
    const Cut cut = cutIntoBlocks(input);
    EXPECT_EQ(cut.blocks.size(), 3u);
    EXPECT_EQ(notesOf(cut, CutNoteKind::PulledEnd).size(), 1u);
    EXPECT_EQ(brokenCut(input), "");
}

TEST(Cut, CloseEndsBecomeOne) {
    CutInput input = squareInput();
    input.settings.tolerance = 1e-3;
    input.traces = {{{-1, 0}, {0, 0}, 1}, {{0.0005, 0.0005}, {0.5, 1}, 2}, {{0.0005, -0.0003}, {0.5, -1}, 3}};
    const Cut cut = cutIntoBlocks(input);
    EXPECT_EQ(cut.blocks.size(), 3u);
    const auto moved = notesOf(cut, CutNoteKind::MovedEnd);
    ASSERT_EQ(moved.size(), 2u);
    EXPECT_NEAR(moved[0].measure, std::hypot(0.0005, 0.0003), 1e-15);
}

TEST(Cut, ATraceAlongTheBorderIsTheBorder) {
    CutInput input = squareInput();
    input.traces = {{{-0.5, 1}, {1.5, 1}, 2}, {{-1, 1e-7 - 1}, {1, -1}, 2}};
    const Cut cut = cutIntoBlocks(input);
    ASSERT_EQ(cut.blocks.size(), 1u);
    EXPECT_EQ(cut.blocks[0].outer.sources, std::vector<int>(4, borderSource));
    const auto merged = notesOf(cut, CutNoteKind::MergedTrace);
    ASSERT_EQ(merged.size(), 2u);
    EXPECT_EQ(merged[0].other, borderSource);
}

TEST(Cut, TheLowerSourceHasWhatTracesShare) {
    CutInput input = squareInput();
    input.traces = {{{-1, 0}, {0.5, 0}, 8}, {{1, 0}, {-0.5, 1e-9}, 3}};
    const Cut cut = cutIntoBlocks(input);
    ASSERT_EQ(cut.blocks.size(), 2u);
    const CutBlock& below = *blockAt(cut, {0, -0.5});
    ASSERT_EQ(below.outer.vertices.size(), 5u);
    const Point change = cut.vertices[below.outer.vertices[3]];
    EXPECT_LT((change - Point(-0.5, 1e-9)).norm(), 1e-15);
    EXPECT_EQ(below.outer.sources, (std::vector<int>{borderSource, borderSource, 3, 8, borderSource}));
    const auto merged = notesOf(cut, CutNoteKind::MergedTrace);
    ASSERT_EQ(merged.size(), 1u);
    EXPECT_EQ(merged[0].source, 8);
    EXPECT_EQ(merged[0].other, 3);
    EXPECT_NEAR(merged[0].measure, 1.0, 1e-8);
}

TEST(Cut, TunnelsThatTouchInACornerLeaveSimpleRings) {
    CutInput input = squareInput();
    addClosed(input, circle({-0.4, 0}, 0.4, 16), 1);
    addClosed(input, circle({0.4, 0}, 0.4, 16), 2);
    const Cut cut = cutIntoBlocks(input);
    const double disc = 0.5 * 16 * 0.16 * std::sin(2.0 * std::numbers::pi / 16);
    expectAreas(cut, {disc, disc, 4.0 - 2.0 * disc});
    ASSERT_EQ(cut.blocks[0].holes.size(), 2u);
    EXPECT_EQ(brokenCut(input), "");
}

TEST(Cut, TunnelsThatTouchAlongAnEdgeShareIt) {
    CutInput input = squareInput();
    addClosed(input, rectangle(-0.5, -0.25, 0, 0.25), 2);
    addClosed(input, rectangle(1e-8, -0.5, 0.5, 0.5), 1);
    const Cut cut = cutIntoBlocks(input);
    expectAreas(cut, {0.25 + 5e-9, 0.5 - 1e-8, 3.25 + 5e-9});  // source 1 has the common edge
    ASSERT_EQ(cut.blocks[0].holes.size(), 1u);
    EXPECT_EQ(cut.blocks[0].holes[0].vertices.size(), 8u);
    EXPECT_EQ(brokenCut(input), "");
}

TEST(Cut, AnOpeningOverTheEdgeIsCutOffThere) {
    CutInput input = squareInput();
    addClosed(input, circle({0, 1}, 0.5, 24, 0.1), 6);
    const Cut cut = cutIntoBlocks(input);
    EXPECT_EQ(cut.blocks.size(), 2u);
    const CutBlock* opening = blockAt(cut, {0, 0.9});
    ASSERT_NE(opening, nullptr);
    EXPECT_NEAR(opening->area, 0.25 * 24 * 0.25 * std::sin(2.0 * std::numbers::pi / 24), 1e-3);
    EXPECT_EQ(std::count(opening->outer.sources.begin(), opening->outer.sources.end(), borderSource), 1);
    EXPECT_TRUE(opening->holes.empty());
    EXPECT_EQ(brokenCut(input), "");
}

TEST(Cut, LooseEndsAndBridgesBoundNothing) {
    CutInput input = squareInput();
    addClosed(input, circle({0, 0}, 0.4, 12), 1);
    input.traces.push_back({{-1, 0}, {0, 0}, 2});  // from the border into the circle
    input.traces.push_back({{0.7, -0.5}, {0.7, 0.5}, 3});  // in the rock
    const Cut cut = cutIntoBlocks(input);
    EXPECT_EQ(cut.blocks.size(), 2u);
    const auto loose = notesOf(cut, CutNoteKind::DroppedLoose);
    ASSERT_EQ(loose.size(), 2u);
    EXPECT_NEAR(loose[0].measure, 1.0, 1e-12);
    EXPECT_NEAR(loose[1].measure, 1.0, 1e-12);
    EXPECT_EQ(brokenCut(input), "");
}

TEST(Cut, ATrimmedEndIsReportedWithItsLength) {
    CutInput input = squareInput();
    input.traces = {{{-1, 0}, {1, 0}, 1}, {{0.25, -1}, {0.25, 0.3}, 2}};
    const Cut cut = cutIntoBlocks(input);
    expectAreas(cut, {2, 1.25, 0.75});
    ASSERT_EQ(cut.notes.size(), 1u);
    EXPECT_EQ(cut.notes[0].kind, CutNoteKind::TrimmedEnd);
    EXPECT_EQ(cut.notes[0].place, Point(0.25, 0.3));
    EXPECT_EQ(cut.notes[0].source, 2);
    EXPECT_NEAR(cut.notes[0].measure, 0.3, 1e-12);
}

TEST(Cut, WhatCannotCutIsReportedAndLeftOut) {
    CutInput input = squareInput();
    const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
    input.traces = {{{0, 0}, {0, 0}, 1}, {{5, 5}, {6, 9}, 2}, {{nan, 0}, {0, 1}, 3}, {{0, 0}, {infinity, 0}, 4},
                    {{-3, 0.5}, {0.5, 3}, 5}};
    input.domains.push_back({2, {{0, 0}, {1, nan}, {1, 1}}});
    input.domains.push_back({3, {{0, 0}, {1, 0}}});
    input.domains.push_back({4, {}});
    const Cut cut = cutIntoBlocks(input);
    EXPECT_EQ(cut.blocks.size(), 1u);
    EXPECT_EQ(notesOf(cut, CutNoteKind::DroppedShort).size(), 1u);
    EXPECT_EQ(notesOf(cut, CutNoteKind::DroppedOutside).size(), 2u);
    EXPECT_EQ(notesOf(cut, CutNoteKind::DroppedNotFinite).size(), 3u);
    EXPECT_EQ(notesOf(cut, CutNoteKind::DroppedDomain).size(), 2u);
    EXPECT_TRUE(cutIntoBlocks(CutInput{}).blocks.empty());
}

TEST(Cut, DomainsThatTouchKeepTheirIdsAndShareCorners) {
    CutInput input;
    input.domains = {{9, rectangle(0, 0, 1, 1)}, {4, rectangle(1, 0.25, 2, 0.75)}};
    input.traces = {{{-1, 0.5}, {3, 0.5}, 1}};
    const Cut cut = cutIntoBlocks(input);
    expectAreas(cut, {0.5, 0.5, 0.25, 0.25});
    EXPECT_EQ(cut.blocks[0].domain, 4);
    EXPECT_EQ(cut.blocks[2].domain, 9);
    EXPECT_EQ(cut.vertices.size(), 4u + 4u + 3u);
    EXPECT_EQ(brokenCut(input), "");
}

TEST(Cut, ASliverJoinsTheNeighbourWithTheLongestEdge) {
    CutInput input = squareInput();
    input.traces = {{{-1, 0}, {1, 0}, 1}, {{-1, 1e-4}, {1, 2e-4}, 2}, {{0.5, -1}, {0.5, 0}, 3}};
    const Cut cut = cutIntoBlocks(input);
    // below the sliver of 3e-4 m² two blocks share 1.5 and 0.5 m with it, above it one shares 2 m
    expectAreas(cut, {2.0, 1.5, 0.5});
    const auto merged = notesOf(cut, CutNoteKind::MergedSliver);
    ASSERT_EQ(merged.size(), 1u);
    EXPECT_EQ(merged[0].source, 2);
    EXPECT_NEAR(merged[0].measure, 3e-4, 1e-12);
    input.settings.minArea = input.settings.minWidth = 0.0;
    expectAreas(cutIntoBlocks(input), {2.0 - 3e-4, 3e-4, 1.5, 0.5});
}

TEST(Cut, ALimitAboveTheDomainLeavesItWholeAndSaysSo) {
    CutInput input = squareInput();
    for (int i = -9; i < 10; ++i) input.traces.push_back({{0.1 * i, -2}, {0.1 * i + 0.05, 2}, 1});
    input.settings.minArea = 5.0;
    const Cut cut = cutIntoBlocks(input);
    expectAreas(cut, {4.0});
    EXPECT_EQ(notesOf(cut, CutNoteKind::MergedSliver).size(), 19u);
    EXPECT_EQ(notesOf(cut, CutNoteKind::KeptSliver).size(), 1u);
}

TEST(Cut, FarFromTheOriginTheBlocksAreTheSame) {
    CutInput input = squareInput();
    std::mt19937 random(8);
    std::uniform_int_distribution<int> lattice(-1024, 1024);  // places that shift without round-off
    const auto place = [&] { return Point(lattice(random) / 1024.0, lattice(random) / 1024.0); };
    for (int i = 0; i < 60; ++i) input.traces.push_back({place(), place(), i % 3});
    input.settings.minArea = 4e-7, input.settings.minWidth = 2e-4;
    const std::vector<double> here = areas(cutIntoBlocks(input));
    const Point shift(4194304.0, -1048576.0);
    for (Point& p : input.domains[0].outline) p += shift;
    for (CutTrace& trace : input.traces) trace = {trace.from + shift, trace.to + shift, trace.source};
    const std::vector<double> there = areas(cutIntoBlocks(input));
    ASSERT_EQ(here.size(), there.size());
    EXPECT_GT(here.size(), 300u);
    for (std::size_t i = 0; i < here.size(); ++i) EXPECT_NEAR(here[i], there[i], 1e-8);
}

TEST(Cut, ManyTracesThroughOnePointAreEachABoundary) {
    CutInput input = squareInput();
    constexpr int count = 500;
    for (int i = 0; i < count; ++i) {
        const double angle = std::numbers::pi * i / count + 1e-3;
        const Point way = 1.9 * Point(std::cos(angle), std::sin(angle));
        input.traces.push_back({-way, way, i});
    }
    input.settings.minWidth = 0.0;
    input.settings.minArea = 1e-9;
    const Cut cut = cutIntoBlocks(input);
    EXPECT_EQ(cut.blocks.size(), 2u * count);
    EXPECT_EQ(brokenCut(input), "");
}

}  // namespace
}  // namespace keyblock
