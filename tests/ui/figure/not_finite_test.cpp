// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Frames with values that are not finite, as a failed stage or a damaged run file has
// them: figures are drawn without these values and say so.
#include "tests/ui/bricks.h"
#include "ui/figure/figure.h"
#include "ui/picture/section/section.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <regex>

namespace keyblock {
namespace {

using Limits = std::numeric_limits<double>;

/// A figure of the bricks after `spoil` has changed their last frame.
std::string svgAfter(FigureKind kind, const std::optional<std::string>& quantity,
                     const std::function<void(Frame&)>& spoil) {
    test::BricksRun bricks;
    spoil(bricks.results.frames.back());
    FigureRequest request;
    request.kind = kind;
    request.quantity = quantity;
    return paintFigure(MemoryRun(bricks.scene, bricks.results), request).bytes;
}

using Spoil = std::function<void(Frame&, double)>;

const std::vector<Spoil> spoils{[](Frame& frame, double value) { frame.blocks[1].stress[0] = value; },
                                [](Frame& frame, double value) {
                                    for (BlockState& block : frame.blocks) block.stress = {value, value, value};
                                },
                                [](Frame& frame, double value) { frame.blocks[2].points[1].x() = value; },
                                [](Frame& frame, double value) {
                                    for (BlockState& block : frame.blocks)
                                        for (Point& corner : block.points) corner = {value, value};
                                },
                                [](Frame& frame, double value) {
                                    frame.blocks[1].displacement = frame.blocks[0].velocity = {value, 0.0};
                                },
                                [](Frame& frame, double value) { frame.bolts[0].nodes[1].axialForce = value; },
                                [](Frame& frame, double value) {
                                    for (BoltNodeFrame& node : frame.bolts[0].nodes)
                                        node.axialForce = node.slip = value;
                                },
                                [](Frame& frame, double value) { frame.bolts[0].nodes[2].position.y() = value; },
                                [](Frame& frame, double value) { frame.bolts[0].nodes[0].bondStrength = value; }};

TEST(NotFinite, EveryFigureEndsAndHasNoSuchNumbers) {
    const std::regex bad(R"([ ,"(](nan|-?inf)\b)");
    for (const double value : {Limits::quiet_NaN(), Limits::infinity(), -1e308, Limits::denorm_min()})
        for (std::size_t i = 0; i < spoils.size(); ++i) {
            const auto spoil = [&](Frame& frame) { spoils[i](frame, value); };
            for (const char* quantity : {"sigma1", "displacement-arrows"})
                EXPECT_FALSE(std::regex_search(svgAfter(FigureKind::Section, quantity, spoil), bad))
                    << quantity << " " << i << " " << value;
            EXPECT_FALSE(std::regex_search(svgAfter(FigureKind::Bolt, {}, spoil), bad)) << i << " " << value;
        }
}

TEST(NotFinite, FiguresSaySo) {
    const auto spoil = [](Frame& frame) {
        frame.blocks[1].stress[0] = Limits::infinity();
        frame.bolts[0].nodes[1].axialForce = Limits::quiet_NaN();
    };
    const std::string text = "values of 1 block and 1 bolt are not finite";
    EXPECT_NE(svgAfter(FigureKind::Section, {}, spoil).find(text), std::string::npos);
    EXPECT_NE(svgAfter(FigureKind::Bolt, {}, spoil).find(text), std::string::npos);
    EXPECT_EQ(svgAfter(FigureKind::Section, {}, [](Frame&) {}).find("not finite"), std::string::npos);
}

TEST(NotFinite, ASectionKeepsWhatIsFinite) {
    test::BricksRun bricks;
    Frame& frame = bricks.results.frames.back();
    frame.blocks[1].points[0].x() = Limits::quiet_NaN();
    frame.blocks[2].stress[1] = Limits::infinity();
    const SectionPicture picture = bricks.picture(1);
    ASSERT_EQ(picture.blocks.size(), 2u);  // without the brick that has no position
    EXPECT_TRUE(picture.blocks[0].value.has_value());
    EXPECT_FALSE(picture.blocks[1].value.has_value());
    EXPECT_LT(picture.window.max.x(), 10.0);
    EXPECT_EQ(picture.notFinite, "values of 2 blocks are not finite, or larger than 1e100, and are not shown");
}

}  // namespace
}  // namespace keyblock
