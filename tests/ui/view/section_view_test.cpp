// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The layers of a section as arrays, and their rendering on the GPU.
#include "tests/ui/bricks.h"
#include "tests/ui/screen/screen.h"
#include "ui/view/force_shapes.h"
#include "ui/view/screen_sizes.h"
#include "ui/view/section_shapes.h"
#include "ui/view/section_view.h"

#include <gtest/gtest.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <array>

namespace keyblock {
namespace {

double areaOf(const LayerShapes& shapes) {
    double area = 0.0;
    const auto corner = [&](std::size_t cell) {
        const auto at = 2 * static_cast<std::size_t>(shapes.cells[cell]);
        return Point(shapes.corners[at], shapes.corners[at + 1]);
    };
    for (std::size_t t = 0; t + 2 < shapes.cells.size(); t += 3)
        area += 0.5 * std::abs(cross(corner(t + 1) - corner(t), corner(t + 2) - corner(t)));
    return area;
}

SectionPicture hook() {
    SectionPicture picture;
    BlockShape block;
    block.before = {{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}};  // concave
    block.outline = block.before;
    for (Point& corner : block.outline) corner = Point(2.0 * corner.x() + 0.5 * corner.y(), corner.y());
    picture.blocks = {block};
    picture.model = {{0, 0}, {8, 3}};
    return picture;
}

TEST(SectionShapes, TrianglesTileConcaveBlocksAfterDisplacement) {
    const SectionPicture picture = hook();
    const LayerShapes blocks = SectionShapes(picture, {0, 0}).blocks({}, false);
    EXPECT_NEAR(areaOf(blocks), 10.0, 1e-4);
    EXPECT_EQ(blocks.colours.size(), 3 * blocks.corners.size() / 2);
}

TEST(SectionShapes, PrecisionIsKeptFarFromTheOrigin) {
    SectionPicture picture = hook();
    const Point away(4.5e5, 5.9e6);
    for (BlockShape& block : picture.blocks)
        for (auto* ring : {&block.outline, &block.before})
            for (Point& corner : *ring) corner += away;
    EXPECT_NEAR(areaOf(SectionShapes(picture, away).blocks({}, false)), 10.0, 1e-4);
}

TEST(SectionShapes, BrokenSteelHasNoShank) {
    test::BricksRun bricks;
    bricks.results.frames[1].bolts[0].nodes[1].ruptured = true;
    const SectionPicture picture = bricks.picture(1);
    EXPECT_EQ(SectionShapes(picture, {0, 0}).shanks(nullptr).cells.size(), 2u * 2u);
    EXPECT_EQ(SectionShapes(picture, {0, 0}).whole({0}).cells.size(), 2u * 3u);
}

TEST(ForceShapes, LengthsInPixelsAreTheSameAtEveryScale) {
    SectionPicture picture;
    picture.arrows = ArrowField{"Velocity", "m/s", {}, {{ArrowShape::Arrow, {0, 0}, {0, 2}}}, 2.0};
    for (const double scale : {10.0, 1000.0}) {
        const LayerShapes lines = forceShapes(picture, {0, 0}, scale, {}, {{-1e9, -1e9}, {1e9, 1e9}}).lines;
        ASSERT_GE(lines.corners.size(), 4u);
        EXPECT_NEAR(lines.corners[3] * scale, arrowScale(*picture.arrows) * 2.0 * pixelsPerMm, 1e-3);
        EXPECT_EQ(lines.widths.size(), lines.cells.size() / 2);
    }
}

class OnGpu : public ::testing::Test {
protected:
    void open() {
        window->SetOffScreenRendering(1);
        window->SetMultiSamples(0);
        window->SetSize(400, 300);
        window->AddRenderer(renderer);
        view = std::make_unique<SectionView>(*renderer);
        colours.ground = rgb(0xFFFFFF);
        colours.wall = rgb(0xFF0000);
        colours.rock = rgb(0x00FF00);
        colours.jointOpacity = 1.0;
    }
    void paint(const SectionPicture& picture, double pixelsPerMetre, const Point& centre) {
        view->show(picture, colours, {});
        view->look(centre, 1.0 / pixelsPerMetre, {400.0, 300.0}, &picture);
        window->Render();
        vtkNew<vtkUnsignedCharArray> bytes;
        window->GetPixelData(0, 0, 399, 299, 0, bytes);
        pixels.assign(bytes->GetPointer(0), bytes->GetPointer(0) + bytes->GetNumberOfValues());
    }
    /// Counted from the lower left.
    Colour at(int x, int y) const {
        const std::size_t first = 3 * (400 * y + x);
        return {pixels[first], pixels[first + 1], pixels[first + 2]};
    }
    vtkNew<vtkRenderWindow> window;
    vtkNew<vtkRenderer> renderer;
    std::unique_ptr<SectionView> view;
    ViewColours colours;
    std::vector<std::uint8_t> pixels;
};

TEST_F(OnGpu, WallsAreTwoPixelsWideAtEveryScale) {
    NEED_SCREEN();
    open();
    SectionPicture picture;
    picture.model = {{-1, -1}, {1, 1}};
    picture.walls = {{{-10.0, 0.0}, {10.0, 0.0}}};
    for (const double scale : {20.0, 2000.0}) {
        paint(picture, scale, {0.0, 0.0});
        EXPECT_EQ(at(200, 149), colours.wall);
        EXPECT_EQ(at(200, 150), colours.wall);
        EXPECT_EQ(at(200, 147), colours.ground);
        EXPECT_EQ(at(200, 152), colours.ground);
    }
}

TEST_F(OnGpu, BlocksAreFilledAtTheirPosition) {
    NEED_SCREEN();
    open();
    SectionPicture picture = hook();
    picture.blocks[0].outline = picture.blocks[0].before;
    paint(picture, 80.0, {1.5, 1.5});
    EXPECT_EQ(at(200 + 80, 150 - 80), colours.rock);  // in the horizontal leg
    EXPECT_EQ(at(200 - 80, 150 + 80), colours.rock);  // in the vertical leg
    EXPECT_EQ(at(200 + 80, 150 + 80), colours.ground);  // in the notch
}

TEST_F(OnGpu, FramesOfOneRunReuseTheConnectivity) {
    NEED_SCREEN();
    open();
    const test::BricksRun bricks;
    for (int turn = 0; turn < 3; ++turn)
        for (const std::size_t frame : {0u, 1u}) paint(bricks.picture(frame), 100.0, {1.0, 1.0});
    EXPECT_EQ(view->joinings(), 1);
    paint(hook(), 100.0, {1.0, 1.0});
    EXPECT_EQ(view->joinings(), 2);
}

TEST_F(OnGpu, EmptyPictureShowsTheBackground) {
    NEED_SCREEN();
    open();
    paint(hook(), 80.0, {1.5, 1.5});
    view->clear(colours);
    window->Render();
    paint(SectionPicture{}, 80.0, {1.5, 1.5});
    EXPECT_EQ(at(120, 230), colours.ground);
}

}  // namespace
}  // namespace keyblock
