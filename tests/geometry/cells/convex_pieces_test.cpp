// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/cells/convex_pieces.h"

#include "geometry/polygon.h"

#include <gtest/gtest.h>

#include <cmath>

namespace keyblock {
namespace {

std::vector<Point> cornersOf(const std::vector<int>& piece, const std::vector<Point>& polygon) {
    std::vector<Point> corners;
    for (const int corner : piece) corners.push_back(polygon[corner]);
    return corners;
}

/// Every piece turns left only, and together they have the polygon's area: so they tile it.
void expectTiled(const std::vector<Point>& polygon, std::size_t pieces) {
    double area = 0.0;
    const auto parts = convexPieces(polygon);
    for (const auto& part : parts) {
        const double own = signedArea(cornersOf(part, polygon));
        EXPECT_GE(own, 0.0);
        area += own;
    }
    EXPECT_EQ(parts.size(), pieces);
    EXPECT_NEAR(area, signedArea(polygon), 1e-12 * signedArea(polygon));
}

TEST(ConvexPieces, LeaveAConvexPolygonWhole) {
    const std::vector<Point> square{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {0, 1}};  // with a straight corner
    expectTiled(square, 1);
    EXPECT_EQ(convexPieces(square)[0], (std::vector<int>{0, 1, 2, 3, 4}));
}

TEST(ConvexPieces, TakeAHairUnderAStraightCornerAsStraight) {
    expectTiled({{0, 0}, {1, 1e-12}, {2, 0}, {2, 1}, {0, 1}}, 1);
}

TEST(ConvexPieces, PartAnArrowheadAndARingThatIsNearlyClosed) {
    expectTiled({{0, 0}, {2, 1}, {0, 2}, {1, 1}}, 2);
    std::vector<Point> ring;  // three quarters round an opening
    for (int i = 0; i <= 18; ++i) ring.emplace_back(3 * std::cos(0.25 * i), 3 * std::sin(0.25 * i));
    for (int i = 18; i >= 0; --i) ring.emplace_back(2 * std::cos(0.25 * i), 2 * std::sin(0.25 * i));
    expectTiled(ring, ring.size() - 2);
}

TEST(ConvexPieces, PartABlockThatTouchesItself) {
    // Two squares with a common corner, which stands there twice.
    expectTiled({{0, 0}, {1, 0}, {1, 1}, {2, 1}, {2, 2}, {1, 2}, {1, 1}, {0, 1}}, 4);
}

}  // namespace
}  // namespace keyblock
