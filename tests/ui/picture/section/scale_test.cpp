// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The colour range of a quantity: all values by default, and the user's choices.
#include "tests/ui/bricks.h"
#include "ui/picture/section/section_ranges.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace keyblock {
namespace {

/// Bricks of which one of less than 2 % of the area has ten times the stress of the others.
struct Sliver : test::BricksRun {
    Sliver() {
        for (Frame& frame : results.frames) frame.blocks[2].area = 0.01;
        for (Frame& frame : results.frames) frame.blocks[2].stress = {0.0, -30e6, 0.0};
    }
    LegendBar blocks(const ScaleChoice& choice, std::size_t frame = 1) const {
        const MemoryRun run(scene, results);
        SectionRequest request;
        request.frame = frame;
        request.blocks = findQuantity(blockQuantities(), "sigma1");
        request.bolts = findQuantity(boltQuantities(), "axial_force");
        request.scales["sigma1"] = choice;
        request.scales["axial_force"] = choice;
        return *sectionPicture(run, request).blockLegend;
    }
};

bool says(const LegendBar& bar, const std::string& note) {
    return std::find(bar.notes.begin(), bar.notes.end(), note) != bar.notes.end();
}

TEST(Scale, SpansAllValuesByDefault) {
    const LegendBar bar = Sliver().blocks({});
    EXPECT_EQ(bar.range, (ValueRange{0.0, 30.0}));
    EXPECT_FALSE(bar.goesAbove || bar.clips());
}

TEST(Scale, NotesWhatItClips) {
    ScaleChoice choice;
    choice.clips = true;
    const LegendBar bar = Sliver().blocks(choice);
    EXPECT_LT(bar.range.high, 10.0);
    EXPECT_TRUE(bar.goesAbove && bar.clips());
    EXPECT_TRUE(says(bar, "extreme 2 % of the area clipped"));
}

TEST(Scale, OfThisFrameIgnoresTheOthers) {
    Sliver run;
    run.results.frames[1].blocks[2].stress = {0.0, -3e6, 0.0};
    ScaleChoice choice;
    choice.of = ScaleOf::ThisFrame;
    EXPECT_EQ(run.blocks({}).range.high, 30.0);
    EXPECT_LE(run.blocks(choice).range.high, 3.0);
    EXPECT_TRUE(says(run.blocks(choice), "scale of this frame"));
}

TEST(Scale, UsesATypedRange) {
    ScaleChoice choice;
    choice.of = ScaleOf::Own;
    choice.own = {2.0, 12.5};
    const LegendBar bar = Sliver().blocks(choice);
    EXPECT_EQ(bar.range, choice.own);
    EXPECT_TRUE(bar.goesBelow && bar.goesAbove);
    EXPECT_FALSE(bar.clips());
}

TEST(Scale, HasAsManyColoursAsSteps) {
    ScaleChoice choice;
    choice.intervals = 4;
    const LegendBar bar = Sliver().blocks(choice);
    std::vector<Colour> seen;
    for (double share = 0.0; share <= 1.0; share += 0.01)
        if (const Colour colour = bar.colourOf(30.0 * share); seen.empty() || !(seen.back() == colour)) seen.push_back(colour);
    EXPECT_EQ(seen.size(), 4u);
    EXPECT_EQ(bar.stops(false).size(), 8u);
    EXPECT_EQ(bar.colourOf(30.0), bar.map->back());
}

TEST(Scale, ReachesThePeakOfABoltBetweenFrames) {
    test::BricksRun run;
    for (Frame& frame : run.results.frames) frame.extremes.resize(frame.bolts.size());
    run.results.frames[1].extremes[0].axialForce.value = -118e3;
    const LegendBar bar = *run.picture(0).boltLegend;
    EXPECT_GE(bar.range.high, 118.0);
    EXPECT_EQ(bar.dashed, "compression");
    EXPECT_TRUE(bar.isDashed(-50.0));
    EXPECT_FALSE(bar.isDashed(50.0) || bar.isDashed(-1e-3));
}

TEST(Scale, ReachesThePeakOfABlockBetweenFrames) {
    test::BricksRun run;
    const LegendBar before = *run.picture(0).blockLegend;
    ASSERT_EQ(before.quantity, "sigma1");
    for (Frame& frame : run.results.frames) frame.blockExtremes.resize(frame.blocks.size());
    run.results.frames[1].blockExtremes[0].sigma1 = {250e6, 0, 0.5};
    const LegendBar bar = *run.picture(0).blockLegend;
    EXPECT_LT(before.range.high, 250.0);
    EXPECT_GE(bar.range.high, 250.0);
}

}  // namespace
}  // namespace keyblock
