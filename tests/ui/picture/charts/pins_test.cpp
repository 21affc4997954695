// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A pin moves with its block or bolt, and its values are those of the frames.
#include "ui/picture/charts/pins.h"

#include "solver/scene/solved_blocks.h"
#include "tests/ui/bricks.h"
#include "ui/picture/section/deformed.h"
#include "ui/picture/section/probe.h"

#include <gtest/gtest.h>

namespace keyblock {
namespace {

using namespace test;

Pick pickAt(const SectionPicture& picture, const Point& place) {
    const auto pick = PickIndex(std::make_shared<const SectionPicture>(picture)).at(place, 0.02);
    EXPECT_TRUE(pick);
    return pick.value_or(Pick{});
}

Pin blockPin(const SectionPicture& picture, const Point& place, std::string_view quantity) {
    return pinAt(picture, pickAt(picture, place), place, findQuantity(blockQuantities(), quantity),
                 findQuantity(boltQuantities(), "axial_force"));
}

TEST(Pins, AFlagMovesWithItsBlockAsItIsDrawn) {
    const BricksRun run;
    const SectionPicture first = run.picture(0), enlarged = run.picture(1, 10.0);
    const Pin pin = blockPin(first, {0.3, 1.2}, "sigma1");
    EXPECT_EQ(pin.where, "Block left");
    EXPECT_NEAR((placeOf(pin, first).value() - Point(0.3, 1.2)).norm(), 0.0, 1e-12);
    EXPECT_NEAR((placeOf(pin, enlarged).value() - Point(0.3, 1.3)).norm(), 0.0, 1e-12);  // ten times 10 mm
    const Pin same = blockPin(enlarged, {0.3, 1.3}, "sigma1");
    EXPECT_NEAR((placeBefore(same, cornersBefore(solvedBlocks(run.scene))) - Point(0.3, 1.2)).norm(), 0.0, 1e-12);
    SectionPicture gone = first;
    gone.blocks.clear();
    EXPECT_FALSE(placeOf(pin, gone));
}

TEST(Pins, HasTheValuesOfTheFrames) {
    const BricksRun run;
    PinTrack stress(blockPin(run.picture(0), {0.3, 1.2}, "sigma1"));
    PinTrack lift(blockPin(run.picture(0), {0.3, 1.2}, "uy"));
    const SectionPicture picture = run.picture(0);
    PinTrack force(pinAt(picture, pickAt(picture, {1.005, 1.25}), {1.0, 1.25}, nullptr,
                         findQuantity(boltQuantities(), "axial_force")));
    for (const Frame& frame : run.results.frames)
        for (PinTrack* track : {&stress, &lift, &force}) track->add(frame);
    EXPECT_EQ(stress.values(), (std::vector<double>{3.0, 3.0}));
    EXPECT_NEAR(lift.values()[1], 10.0, 1e-9);
    EXPECT_EQ(force.pin().where, "B at 0.75 m");
    EXPECT_EQ(force.values(), (std::vector<double>{1.0, 100.0}));
}

TEST(Pins, AMissingBlockHasNoValueAndDisplacementsRestartFromZero) {
    const BricksRun run;
    PinTrack track(blockPin(run.picture(0), {0.3, 1.2}, "displacement"));
    Frame frame = run.results.frames[1];
    track.add(run.results.frames[0]);
    track.add(frame);
    BlockState& left = frame.blocks[1];
    left.displacement = Point(0.0, 0.002);  // set to zero in between, then lifted by 2 mm
    left.centroid += Point(0.0, 0.002);
    for (Point& point : left.points) point += Point(0.0, 0.002);
    track.add(frame);
    left.area = 0.0;
    track.add(frame);
    ASSERT_EQ(track.frames(), 4u);
    EXPECT_NEAR(track.values()[1], 10.0, 1e-9);
    EXPECT_NEAR(track.values()[2], 2.0, 1e-9);
    EXPECT_TRUE(std::isnan(track.values()[3]));
}

TEST(Pins, AreChartedByQuantityFourToAChart) {
    const BricksRun run;
    const MemoryRun source(run.scene, run.results);
    std::vector<std::shared_ptr<const PinTrack>> tracks;
    for (int i = 0; i < 6; ++i) {
        Pin pin = blockPin(run.picture(0), {0.3, 1.2}, i == 5 ? "uy" : "sigma1");
        pin.number = i + 1;
        auto track = std::make_shared<PinTrack>(pin);
        for (const Frame& frame : run.results.frames) track->add(frame);
        tracks.push_back(track);
    }
    const std::vector<Chart> charts = pinCharts(source, tracks);
    ASSERT_EQ(charts.size(), 3u);
    EXPECT_EQ(charts[0].panels[0].title, "Block stress σ₁ (MPa)");
    EXPECT_EQ(charts[0].panels[0].curves.size(), 4u);
    EXPECT_EQ(charts[1].panels[0].curves.size(), 1u);
    EXPECT_EQ(charts[2].panels[0].curves[0].name, "6 Block left");
    EXPECT_TRUE(pinCharts(source, {std::make_shared<PinTrack>(tracks[0]->pin())}).empty());  // no frame read yet
}

TEST(Probe, ListsTheShownQuantityFirst) {
    const BricksRun run;
    const SectionPicture picture = run.picture(1);
    const auto* shown = findQuantity(blockQuantities(), "uy");
    const ProbeReading block =
        probed(picture, run.results.frames[1], pickAt(picture, {0.3, 1.2}), shown, nullptr);
    EXPECT_EQ(block.head, "Block left");
    ASSERT_EQ(block.rows.size(), 5u);
    EXPECT_EQ(block.rows[0].first, "Displacement along y");
    EXPECT_EQ(block.rows[0].second, "10 mm");
    EXPECT_EQ(block.rows[1].first, "σ₁");
    const ProbeReading bolt = probed(picture, run.results.frames[1], pickAt(picture, {1.0, 0.5}), nullptr, nullptr);
    EXPECT_EQ(bolt.head, "B at 0.00 m");
    EXPECT_EQ(bolt.rows.back().second, "bonded");
}

TEST(Probe, ShowsPeaksBetweenFramesAndNoRoundOff) {
    BricksRun run;
    Frame& frame = run.results.frames[1];
    const SectionPicture picture = run.picture(1);
    const Pick pick = pickAt(picture, {0.3, 1.2});
    const std::size_t row = pick.block;
    frame.blockExtremes.resize(frame.blocks.size());
    frame.blockExtremes[row].displacement = {0.5, 0, 0.1};
    frame.blocks[row].stress = {2.9e-10, 0.0, 0.0};
    const ProbeReading block = probed(picture, frame, pick, nullptr, nullptr);
    EXPECT_EQ(block.rows[0].second, "0 MPa");
    EXPECT_EQ(block.rows[2].first, "Displacement");
    EXPECT_TRUE(block.rows[2].second.ends_with(" mm, peak 500")) << block.rows[2].second;
    SectionPicture si = picture;
    showAs(si, {true, false});
    EXPECT_TRUE(probed(si, frame, pick, nullptr, nullptr).rows[2].second.ends_with(" m, peak 0.5"));
}

}  // namespace
}  // namespace keyblock
