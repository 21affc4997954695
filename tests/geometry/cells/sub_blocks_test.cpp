// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cells must fill their block, share every inner edge, and be no slivers,
// whatever the outline and wherever its corners begin.
#include "geometry/cells/sub_blocks.h"

#include "geometry/polygon.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>

namespace keyblock {
namespace {

using Outline = std::vector<Point>;
constexpr double cellTolerance = 1e-9;

double lengthAround(const Outline& outline) {
    double length = 0.0;
    for (std::size_t i = 0; i < outline.size(); ++i) length += (outline[(i + 1) % outline.size()] - outline[i]).norm();
    return length;
}

void expectSoundCells(const Outline& outline, double size, const std::string& what) {
    const SubBlocks cut = cutIntoCells(outline, size, cellTolerance);
    const double area = std::abs(signedArea(outline));
    double sum = 0.0, around = 0.0, inner = 0.0, least = area;
    for (const Outline& cell : cut.cells) {
        EXPECT_FALSE(crossesItself(cell, cellTolerance)) << what;
        sum += signedArea(cell);
        around += lengthAround(cell);
        least = std::min(least, signedArea(cell));
    }
    for (const SharedEdge& edge : cut.shared) inner += (edge.to - edge.from).norm();
    EXPECT_NEAR(sum / area, 1.0, 1e-12) << what;
    EXPECT_NEAR(around - 2.0 * inner, lengthAround(outline), 1e-7 * around) << what;
    if (cut.cells.size() > 1) {
        EXPECT_GE(least, leastCellShare * cut.cellArea * (1.0 - 1e-9)) << what;
    }
}

Outline starOutline(std::mt19937& random, int corners) {
    std::uniform_real_distribution<double> radius(0.3, 2.0);
    Outline outline;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / corners;
        outline.push_back(radius(random) * Point(std::cos(angle), std::sin(angle)));
    }
    return outline;
}

TEST(SubBlocks, ARectangleFallsIntoEqualCells) {
    const SubBlocks cut = cutIntoCells(Outline{{0, 0}, {10, 0}, {10, 1}, {0, 1}}, 0.25, cellTolerance);
    ASSERT_EQ(cut.cells.size(), 160u);
    EXPECT_EQ(cut.shared.size(), 39u * 4u + 40u * 3u);
    for (const Outline& cell : cut.cells) {
        EXPECT_EQ(cell.size(), 4u);
        EXPECT_NEAR(signedArea(cell), 0.0625, 1e-15);
    }
    EXPECT_LT(moments(cut.cells[1]).centroid.x(), 0.25);  // the second cell lies above the first
    EXPECT_GT(moments(cut.cells[1]).centroid.y(), 0.25);
}

TEST(SubBlocks, SharedEdgesRunWithTheFirstCellOnTheirLeft) {
    const SubBlocks cut = cutIntoCells(Outline{{0, 0}, {3, 0}, {3, 2}, {0, 2}}, 1.0, cellTolerance);
    for (const SharedEdge& edge : cut.shared) {
        const Point middle = 0.5 * (edge.from + edge.to);
        const Point toA = moments(cut.cells[edge.a]).centroid - middle;
        EXPECT_GT(cross(edge.to - edge.from, toA), 0.0);
    }
}

TEST(SubBlocks, OutlinesWithCornersOnTheGridKeepTheirArea) {
    expectSoundCells({{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 3}, {4, 3}, {4, 4}, {0, 4}}, 1.0, "a C on the grid's lines");
    expectSoundCells({{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 3}, {4, 3}, {4, 4}, {0, 4}}, 0.7, "a C off them");
    expectSoundCells({{0, 0}, {4, 0}, {3, 1}, {2, 0.5}, {1, 1}}, 0.5, "a notch");
    expectSoundCells({{0, 0}, {4, 0}, {4, 3}, {2, 1}, {0, 3}}, 1.0, "a notch that ends on a crossing");
    expectSoundCells({{0, 0}, {10, 0}, {10, 0.02}, {0, 1}}, 0.3, "a wedge");
    expectSoundCells({{0, 0}, {1, 0}, {0, 1}}, 0.1, "a triangle");
    expectSoundCells({{0, 0}, {1, 0}, {1, 1}}, 5.0, "smaller than a cell");
}

TEST(SubBlocks, CellsFillAnyOutlineWithoutSlivers) {
    std::mt19937 random(5);
    for (int i = 0; i < 300; ++i) {
        const Outline outline = starOutline(random, 3 + i % 9);
        expectSoundCells(outline, 0.15 + 0.01 * (i % 50), "star " + std::to_string(i));
    }
}

TEST(SubBlocks, TheFirstCornerAndTheWayRoundDoNotMatter) {
    std::mt19937 random(11);
    for (int i = 0; i < 50; ++i) {
        Outline outline = starOutline(random, 5 + i % 5);
        const SubBlocks first = cutIntoCells(outline, 0.3, cellTolerance);
        std::rotate(outline.begin(), outline.begin() + 2, outline.end());
        std::reverse(outline.begin(), outline.end());
        const SubBlocks again = cutIntoCells(outline, 0.3, cellTolerance);
        ASSERT_EQ(first.cells.size(), again.cells.size());
        for (std::size_t c = 0; c < first.cells.size(); ++c)
            EXPECT_LT((moments(first.cells[c]).centroid - moments(again.cells[c]).centroid).norm(), 1e-11);
    }
}

TEST(SubBlocks, ASquareIsCutUprightFromEveryCorner) {
    const Outline square{{1e-12, 0}, {1, 0}, {1, 1}, {0, 1}};
    const SubBlocks cut = cutIntoCells(square, 0.5, cellTolerance);
    ASSERT_EQ(cut.cells.size(), 4u);
    EXPECT_NEAR(moments(cut.cells[0]).centroid.x(), 0.25, 1e-9);
    EXPECT_NEAR(moments(cut.cells[0]).centroid.y(), 0.25, 1e-9);
}

}  // namespace
}  // namespace keyblock
