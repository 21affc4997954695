// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The canvas on a screen: real widgets, real mouse events, and the resulting pixels.
#include "tests/ui/bricks.h"
#include "tests/ui/screen/screen.h"
#include "ui/canvas/canvas.h"
#include "ui/canvas/legend_panel.h"
#include "ui/canvas/scale_bar.h"
#include "ui/canvas/view_theme.h"
#include "ui/look/theme.h"

#include <QImage>
#include <QPixmap>
#include <QTest>
#include <QWheelEvent>

#include <gtest/gtest.h>

namespace keyblock {
namespace {

std::shared_ptr<const SectionPicture> pictureOf(const test::BricksRun& bricks, std::optional<std::size_t> frame) {
    return std::make_shared<SectionPicture>(bricks.picture(frame));
}

/// A tool that records its input.
struct NotingTool : CanvasTool {
    void press(const CanvasEvent& event) override { pressed = event; }
    void move(const CanvasEvent&) override { ++moves; }
    void release(const CanvasEvent& event) override { released.push_back(event.button); }
    void leave() override { ++leaves; }
    std::optional<CanvasEvent> pressed;
    std::vector<Qt::MouseButton> released;
    int moves = 0, leaves = 0;
};

bool isNear(const QColor& a, const Colour& b) {
    return std::abs(a.red() - b.red) <= 2 && std::abs(a.green() - b.green) <= 2 && std::abs(a.blue() - b.blue) <= 2;
}

void turnWheel(Canvas& canvas, const QPointF& at, int notches) {
    QWheelEvent event(at, canvas.mapToGlobal(at.toPoint()), {}, {0, 120 * notches}, Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(&canvas, &event);
}

class OnCanvas : public ::testing::Test {
protected:
    void open() {
        themes = std::make_unique<Themes>();
        themes->choose(false);
        canvas = std::make_unique<Canvas>(*themes);
        canvas->resize(800, 600);
        canvas->show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(canvas.get()));
    }
    QImage painted() {
        settle();
        return canvas->grab().toImage();
    }
    QColor at(const QImage& image, const Point& place) const {
        const QPointF pixel = canvas->map().toPixel(place);
        return image.pixelColor(pixel.toPoint());
    }
    test::BricksRun bricks;
    std::unique_ptr<Themes> themes;
    std::unique_ptr<Canvas> canvas;
};

TEST_F(OnCanvas, BlocksHaveTheColoursOfTheLegendInBothThemes) {
    NEED_SCREEN();
    open();
    const auto picture = pictureOf(bricks, bricks.results.frames.size() - 1);
    canvas->show(picture);
    canvas->zoomTo(picture->model);
    for (const bool dark : {false, true}) {
        themes->choose(dark);
        const QImage image = painted();
        for (const BlockShape& block : picture->blocks) {
            const Point aside = moments(block.outline).centroid + Point(0.3, 0.15);
            const Colour colour = colourAt(picture->blockLegend->mapOn(dark), picture->blockLegend->shareOf(*block.value));
            EXPECT_TRUE(isNear(at(image, aside), colour)) << block.name << (dark ? " dark" : " light");
        }
    }
    themes->choose(false);
}

TEST_F(OnCanvas, DrawingShowsPlainRockWithItsJoints) {
    NEED_SCREEN();
    open();
    canvas->setDrawing(true);
    canvas->show(pictureOf(bricks, {}));
    const QImage image = painted();
    EXPECT_TRUE(isNear(at(image, {0.5, 1.3}), colourOf(themes->current().rock)));
    EXPECT_GT(std::abs(at(image, {0.5, 1.0}).lightness() - at(image, {0.5, 1.1}).lightness()), 40);
}

TEST_F(OnCanvas, FitsNextToALegendThatAppears) {
    NEED_SCREEN();
    open();
    canvas->setDrawing(true);
    canvas->show(pictureOf(bricks, {}));
    canvas->setDrawing(false);
    const auto results = pictureOf(bricks, 1);
    canvas->show(results);
    const double right = canvas->map().toPixel(results->window.max).x();
    EXPECT_LE(right, canvas->width() - legendExtent);
    auto flown = std::make_shared<SectionPicture>(*results);
    flown->window.max.x() += 5.0;
    canvas->show(flown);
    EXPECT_LE(canvas->map().toPixel(flown->window.max).x(), canvas->width() - legendExtent);
    const double scale = canvas->map().pixelsPerMetre();
    canvas->zoomBy(3.0, {100.0, 100.0});
    canvas->show(pictureOf(bricks, {}));
    canvas->show(results);
    EXPECT_NEAR(canvas->map().pixelsPerMetre(), 3.0 * scale, 1e-6 * scale);  // where the user left it
}

TEST_F(OnCanvas, NarrowCanvasShowsTheColourBarsBelowTheSection) {
    NEED_SCREEN();
    open();
    const auto results = pictureOf(bricks, 1);
    canvas->show(results);
    for (const QSize size : {QSize(440, 500), QSize(370, 363)}) {
        canvas->resize(size);
        canvas->fit();
        painted();
        const LegendContent content{*results, nullptr, {}};
        const QRectF legend = legendRect(themes->current(), content, canvas->size());
        ASSERT_FALSE(legend.isEmpty());
        EXPECT_GE(legend.top(), canvas->map().toPixel(results->window.min).y());
        EXPECT_FALSE(legend.intersects(scaleBarRect(canvas->map())));
        EXPECT_FALSE(legendPartRect(themes->current(), content, canvas->size(), LegendPart::Blocks).isEmpty());
    }
}

TEST_F(OnCanvas, ClickOnTheLegendOpensItsScale) {
    NEED_SCREEN();
    open();
    NotingTool tool;
    canvas->setTool(&tool);
    canvas->show(pictureOf(bricks, 1));
    painted();
    std::vector<LegendPart> asked;
    QObject::connect(canvas.get(), &Canvas::legendClicked, canvas.get(), [&](LegendPart part) { asked.push_back(part); });
    const int middle = canvas->width() - static_cast<int>(0.5 * legendExtent);
    QTest::mouseClick(canvas.get(), Qt::LeftButton, {}, {middle, 40});
    QTest::mouseClick(canvas.get(), Qt::LeftButton, {}, {middle, 160});
    EXPECT_EQ(asked, (std::vector<LegendPart>{LegendPart::Blocks, LegendPart::Bolts}));
    EXPECT_FALSE(tool.pressed);
    canvas->setTool(nullptr);
}

TEST_F(OnCanvas, WheelKeepsThePointUnderTheCursor) {
    NEED_SCREEN();
    open();
    canvas->show(pictureOf(bricks, {}));
    const QPointF cursor(123.0, 456.0);
    const Point before = canvas->map().toPlace(cursor);
    const double scale = canvas->map().pixelsPerMetre();
    turnWheel(*canvas, cursor, 3);
    EXPECT_GT(canvas->map().pixelsPerMetre(), 1.5 * scale);
    EXPECT_LT((canvas->map().toPlace(cursor) - before).norm(), 1e-9);
    turnWheel(*canvas, cursor, -3);
    EXPECT_NEAR(canvas->map().pixelsPerMetre(), scale, 1e-6 * scale);
}

TEST_F(OnCanvas, MiddleButtonPansAndTheToolDoesNotSeeIt) {
    NEED_SCREEN();
    open();
    NotingTool tool;
    canvas->show(pictureOf(bricks, {}));
    canvas->setTool(&tool);
    const Point before = canvas->map().centre();
    QTest::mousePress(canvas.get(), Qt::MiddleButton, {}, {300, 300});
    QTest::mouseMove(canvas.get(), {340, 280});
    QTest::mouseRelease(canvas.get(), Qt::MiddleButton, {}, {340, 280});
    const Point moved = (canvas->map().centre() - before) * canvas->map().pixelsPerMetre();
    EXPECT_NEAR(moved.x(), -40.0, 1e-6);
    EXPECT_NEAR(moved.y(), -20.0, 1e-6);
    EXPECT_FALSE(tool.pressed);
    QTest::mouseClick(canvas.get(), Qt::LeftButton, {}, {100, 100});
    ASSERT_TRUE(tool.pressed);
    EXPECT_LT((tool.pressed->place - canvas->map().toPlace({100, 100})).norm(), 1e-12);
    canvas->setTool(nullptr);
}

TEST_F(OnCanvas, DragEndsAtItsReleaseEvenDuringAPan) {
    NEED_SCREEN();
    open();
    NotingTool tool;
    canvas->show(pictureOf(bricks, {}));
    canvas->setTool(&tool);
    QTest::mousePress(canvas.get(), Qt::LeftButton, {}, {300, 300});
    QTest::mousePress(canvas.get(), Qt::MiddleButton, {}, {310, 300});
    QTest::mouseRelease(canvas.get(), Qt::LeftButton, {}, {330, 300});
    EXPECT_EQ(tool.released, std::vector{Qt::LeftButton});
    QTest::mouseRelease(canvas.get(), Qt::MiddleButton, {}, {340, 300});
    EXPECT_EQ(tool.released.size(), 1u);  // that release belonged to the pan
    QTest::mousePress(canvas.get(), Qt::LeftButton, {}, {300, 300});
    const int moves = tool.moves;
    QTest::mouseMove(canvas.get(), {320, 300});
    EXPECT_GT(tool.moves, moves);
    canvas->setTool(nullptr);
}

TEST_F(OnCanvas, BoxZoomWorksOnceAndTheToolDoesNotSeeIt) {
    NEED_SCREEN();
    open();
    NotingTool tool;
    canvas->show(pictureOf(bricks, {}));
    canvas->setTool(&tool);
    const Point from = canvas->map().toPlace({300, 300}), to = canvas->map().toPlace({340, 330});
    const double scale = canvas->map().pixelsPerMetre();
    canvas->startZoomBox();
    QTest::mousePress(canvas.get(), Qt::LeftButton, {}, {300, 300});
    QTest::mouseMove(canvas.get(), {340, 330});
    QTest::mouseRelease(canvas.get(), Qt::LeftButton, {}, {340, 330});
    EXPECT_FALSE(tool.pressed);
    EXPECT_GT(canvas->map().pixelsPerMetre(), 3.0 * scale);
    const Box shown = canvas->map().window();
    for (const Point& corner : {from, to}) EXPECT_TRUE((corner.array() > shown.min.array()).all() &&
                                                       (corner.array() < shown.max.array()).all());
    EXPECT_FALSE(canvas->endZoomBox());
    canvas->startZoomBox();
    EXPECT_TRUE(canvas->endZoomBox());
    QTest::mouseClick(canvas.get(), Qt::LeftButton, {}, {100, 100});
    EXPECT_TRUE(tool.pressed);
    canvas->setTool(nullptr);
}

TEST_F(OnCanvas, SpaceDragPansAndSpaceAloneIsSignalled) {
    NEED_SCREEN();
    open();
    canvas->show(pictureOf(bricks, {}));
    int taps = 0;
    QObject::connect(canvas.get(), &Canvas::spaceTapped, canvas.get(), [&] { ++taps; });
    const Point before = canvas->map().centre();
    QTest::keyPress(canvas.get(), Qt::Key_Space);
    QTest::mousePress(canvas.get(), Qt::LeftButton, {}, {300, 300});
    QTest::mouseMove(canvas.get(), {330, 300});
    QTest::mouseRelease(canvas.get(), Qt::LeftButton, {}, {330, 300});
    QTest::keyRelease(canvas.get(), Qt::Key_Space);
    EXPECT_GT((canvas->map().centre() - before).norm(), 0.0);
    EXPECT_EQ(taps, 0);
    QTest::keyClick(canvas.get(), Qt::Key_Space);
    EXPECT_EQ(taps, 1);
}

TEST_F(OnCanvas, FitShowsTheExcavationThenTheWholeModel) {
    NEED_SCREEN();
    open();
    auto picture = std::make_shared<SectionPicture>(*pictureOf(bricks, {}));
    picture->window = {{1.0, 1.0}, {2.0, 2.0}};
    canvas->show(picture);
    const auto shows = [&](const Box& box) {
        const Box window = canvas->map().window();
        return meets(box, window) && window.min.x() < box.min.x() && window.max.x() > box.max.x() &&
               window.min.y() < box.min.y() && window.max.y() > box.max.y();
    };
    EXPECT_TRUE(shows(picture->window));
    EXPECT_FALSE(shows(picture->model));
    canvas->fit();
    EXPECT_TRUE(shows(picture->model));
    canvas->fit();
    EXPECT_FALSE(shows(picture->model));
}

TEST_F(OnCanvas, FittedViewIsKeptInASmallerCanvasUntilAPan) {
    NEED_SCREEN();
    open();
    auto picture = pictureOf(bricks, {});
    canvas->show(picture);
    const auto isWhole = [&] {
        const Box window = canvas->map().window();
        return (window.min.array() < picture->window.min.array()).all() &&
               (window.max.array() > picture->window.max.array()).all();
    };
    ASSERT_TRUE(isWhole());
    canvas->resize(400, 300);
    ASSERT_TRUE(waitFor([&] { return canvas->map().size() == QSizeF(400, 300); }));
    EXPECT_TRUE(isWhole());
    canvas->panBy({1.0, 0.0});
    const double scale = canvas->map().pixelsPerMetre();
    canvas->resize(200, 150);
    ASSERT_TRUE(waitFor([&] { return canvas->map().size() == QSizeF(200, 150); }));
    EXPECT_DOUBLE_EQ(canvas->map().pixelsPerMetre(), scale);
}

TEST_F(OnCanvas, EmptyPictureDoesNotCrash) {
    NEED_SCREEN();
    open();
    EXPECT_FALSE(painted().isNull());
    canvas->fit();
    EXPECT_FALSE(canvas->pickAt({10, 10}));
    canvas->show(std::make_shared<SectionPicture>());  // no block, no bolt
    canvas->fit();
    turnWheel(*canvas, {1, 1}, 1000);
    turnWheel(*canvas, {1, 1}, -2000);
    EXPECT_TRUE(canvas->map().window().min.allFinite());
    EXPECT_FALSE(painted().isNull());
    canvas->show(nullptr);
    EXPECT_FALSE(painted().isNull());
}

}  // namespace
}  // namespace keyblock
