// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cells must fill the region, share their sides, be convex where the region lets
// them, and hold the points that are nearest to their sites.
#include "geometry/cells/voronoi.h"

#include "geometry/angle.h"
#include "geometry/cells/site_cells.h"
#include "geometry/cut/cut.h"
#include "geometry/polygon.h"
#include "geometry/random.h"
#include "geometry/segment.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <string>
#include <utility>

namespace keyblock {
namespace {

using Polygon = std::vector<Point>;
using Place = std::pair<double, double>;

constexpr double tolerance = 1e-9;

const Polygon square{{0, 0}, {10, 0}, {10, 10}, {0, 10}};
const Polygon notched{{0, 0}, {10, 0}, {10, 6}, {5.2, 6}, {5.2, 1}, {4.8, 1}, {4.8, 6}, {0, 6}};
const Polygon strip{{0, 0}, {30, 4}, {30, 4.3}, {0, 0.3}};

Polygon star(std::uint64_t seed) {
    Random random(seed);
    Polygon outline;
    for (int i = 0; i < 13; ++i) outline.push_back((1.0 + 5.0 * random.uniform()) * directionOf(360.0 * i / 13));
    return outline;
}

double perimeter(const Polygon& outline) {
    double length = 0.0;
    for (std::size_t i = 0; i < outline.size(); ++i) length += (outline[(i + 1) % outline.size()] - outline[i]).norm();
    return length;
}

/// Corners that turn to the right, in square metres of the triangle; corners of the region are not counted.
double worstTurn(const Polygon& cell, const Polygon& region) {
    double worst = 0.0;
    for (std::size_t i = 0; i < cell.size(); ++i) {
        const Point &a = cell[i], &b = cell[(i + 1) % cell.size()], &c = cell[(i + 2) % cell.size()];
        const auto isB = [&](const Point& p) { return (p - b).norm() <= tolerance; };
        if (std::any_of(region.begin(), region.end(), isB)) continue;
        worst = std::max(worst, -cross(b - a, c - b));
    }
    return worst;
}

void expectSound(const Polygon& region, double size, std::uint64_t seed, const std::string& what) {
    const VoronoiCells v = voronoiCells(region, size, seed, tolerance);
    double area = 0.0, around = 0.0, inner = 0.0;
    std::set<Place> corners;
    std::set<std::pair<Place, Place>> sides;
    for (const Polygon& cell : v.cells) {
        EXPECT_GT(signedArea(cell), 0.0) << what;
        EXPECT_LE(worstTurn(cell, region), 1e-12 * size * size) << what;
        area += signedArea(cell);
        around += perimeter(cell);
        for (std::size_t i = 0; i < cell.size(); ++i) {
            const Point &a = cell[i], &b = cell[(i + 1) % cell.size()];
            corners.insert({a.x(), a.y()});
            sides.insert(std::minmax(Place(a.x(), a.y()), Place(b.x(), b.y())));
        }
    }
    for (const Segment& edge : v.edges) {
        inner += (edge.to - edge.from).norm();
        EXPECT_TRUE(sides.contains(std::minmax(Place(edge.from.x(), edge.from.y()), Place(edge.to.x(), edge.to.y()))));
    }
    EXPECT_EQ(v.sites.size(), v.cells.size()) << what;
    EXPECT_NEAR(area / std::abs(signedArea(region)), 1.0, 1e-12) << what;
    EXPECT_NEAR(around - 2.0 * inner, perimeter(region), 1e-9 * around) << what;
    // Euler: corners − sides + cells = 1 for a disc that is cut up.
    EXPECT_EQ(corners.size() + v.cells.size(), sides.size() + 1u) << what;
}

TEST(Voronoi, CellsFillTheRegionAndShareTheirSides) {
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        expectSound(square, 1.0, seed, "square " + std::to_string(seed));
        expectSound(notched, 0.7, seed, "notched " + std::to_string(seed));
        expectSound(strip, 0.5, seed, "strip " + std::to_string(seed));
        expectSound(star(seed), 0.6, seed, "star " + std::to_string(seed));
    }
}

TEST(Voronoi, SizesFromHugeToTinyAreFine) {
    for (const double size : {1e3, 20.0, 9.0, 5.0, 3.0, 2.0, 0.15})
        for (std::uint64_t seed = 1; seed <= 5; ++seed) {
            expectSound(square, size, seed, "square, size " + std::to_string(size));
            expectSound(notched, size, seed, "notched, size " + std::to_string(size));
            expectSound(star(seed), size, seed, "star, size " + std::to_string(size));
        }
}

TEST(Voronoi, OneCellWhereTheRegionIsSmallerThanTheSize) {
    const VoronoiCells v = voronoiCells(square, 50.0, 1, tolerance);
    ASSERT_EQ(v.cells.size(), 1u);
    EXPECT_EQ(v.cells[0], square);
    EXPECT_TRUE(v.edges.empty());
    EXPECT_EQ(voronoiCells(square, 1e300, 1, tolerance).cells, v.cells);
}

TEST(Voronoi, OfTwoSitesTheEdgeIsTheirBisector) {
    const Polygon box{{0, 0}, {2, 0}, {2, 1}, {0, 1}};
    const VoronoiCells v = voronoiCells(box, 1.0, 4, tolerance);
    ASSERT_EQ(v.cells.size(), 2u);
    ASSERT_EQ(v.edges.size(), 1u);
    for (const Point& end : {v.edges[0].from, v.edges[0].to})
        EXPECT_NEAR((end - v.sites[0]).norm(), (end - v.sites[1]).norm(), 1e-14);
}

TEST(Voronoi, ACellHoldsThePointsNearestToItsSite) {
    for (const Polygon& region : {square, notched, star(3)}) {
        const VoronoiCells v = voronoiCells(region, 0.8, 9, tolerance);
        const Box box = boxOf(region);
        Random random(77);
        int asked = 0;
        while (asked < 2000) {
            const Point p = box.min + Point(random.uniform(), random.uniform()).cwiseProduct(box.max - box.min);
            if (locate(region, p, 1e-6) != Side::Inside) continue;
            ++asked;
            std::size_t holder = v.cells.size();
            for (std::size_t i = 0; i < v.cells.size(); ++i)
                if (locate(v.cells[i], p, 0.0) != Side::Outside) holder = i;
            ASSERT_LT(holder, v.cells.size());
            for (const Point& site : v.sites)
                EXPECT_LE((p - v.sites[holder]).norm(), (p - site).norm() + 1e-12);
        }
    }
}

TEST(Voronoi, CellsAreOfOneSizeAndRound) {
    const VoronoiCells v = voronoiCells({{Point(0, 0), Point(30, 0), Point(30, 20), Point(0, 20)}}, 0.5, 2, tolerance);
    EXPECT_EQ(v.cells.size(), 2400u);  // a site in every square: the mean area is size² exactly
    double squares = 0.0, least = 1.0, roundness = 1.0;
    for (const Polygon& cell : v.cells) {
        const double area = signedArea(cell) / 0.25, around = perimeter(cell) / 0.5;
        squares += (area - 1.0) * (area - 1.0) / 2400.0;
        least = std::min(least, area);
        roundness = std::min(roundness, 4.0 * std::numbers::pi * area / (around * around));
    }
    // Ten seeds: 0.09 and at least 0.67. Without moves the deviation is 0.24 and the smallest cell 0.14.
    EXPECT_LT(std::sqrt(squares), 0.12);
    EXPECT_GT(least, 0.55);
    EXPECT_GT(roundness, 0.5);
}

TEST(Voronoi, WhichWayTheRegionRunsDoesNotMatter) {
    Polygon reversed(square.rbegin(), square.rend());
    const VoronoiCells a = voronoiCells(square, 1.0, 3, tolerance), b = voronoiCells(reversed, 1.0, 3, tolerance);
    ASSERT_EQ(a.edges.size(), b.edges.size());
    for (std::size_t i = 0; i < a.sites.size(); ++i) EXPECT_LT((a.sites[i] - b.sites[i]).norm(), 1e-12);
}

TEST(Voronoi, ASeedMeansTheSameCellsAndAnotherSeedOthers) {
    const VoronoiCells a = voronoiCells(square, 1.0, 3, tolerance);
    EXPECT_EQ(voronoiCells(square, 1.0, 3, tolerance).edges, a.edges);
    const VoronoiCells other = voronoiCells(square, 1.0, 4, tolerance);
    EXPECT_GT((a.sites[0] - other.sites[0]).norm(), 1e-3);
    // From a program in another language that cuts the square by every bisector.
    EXPECT_EQ(a.cells.size(), 100u);
    EXPECT_LT((a.sites[0] - Point(0.5099311350993376, 0.5372579313424884)).norm(), 1e-12);
    EXPECT_LT((a.sites[50] - Point(0.5211748695274211, 5.479898573546482)).norm(), 1e-12);
}

TEST(Voronoi, MovedFarAwayTheCellsAreTheSame) {
    const Point far(1e6, -3e5);
    Polygon moved = notched;
    for (Point& p : moved) p += far;
    const VoronoiCells here = voronoiCells(notched, 0.7, 5, tolerance), there = voronoiCells(moved, 0.7, 5, 1e-8);
    ASSERT_EQ(here.cells.size(), there.cells.size());
    double area = 0.0;
    for (std::size_t i = 0; i < here.cells.size(); ++i) {
        EXPECT_LT((here.sites[i] + far - there.sites[i]).norm(), 1e-8);
        EXPECT_EQ(here.cells[i].size(), there.cells[i].size());
        area += signedArea(there.cells[i]);
    }
    // There the places of doubles are 1e-10 m apart; shared corners cancel, so only the border counts.
    EXPECT_NEAR(area / signedArea(moved), 1.0, 1e-10);
}

TEST(Voronoi, CutAlongTheEdgesTheRegionFallsIntoTheCells) {
    CutSettings settings;
    settings.tolerance = 1e-7;
    settings.minArea = settings.minWidth = 0.0;
    for (const Polygon& region : {square, notched, star(3)}) {
        const VoronoiCells v = voronoiCells(region, 0.8, 9, tolerance);
        std::vector<CutTrace> traces;
        for (const Segment& edge : v.edges) traces.push_back({edge.from, edge.to, 0});
        const CutDomain domain{0, region};
        const Cut cut = cutIntoBlocks({&domain, 1}, traces, settings);
        ASSERT_EQ(cut.blocks.size(), v.cells.size());
        std::vector<double> blocks, cells;
        for (const CutBlock& block : cut.blocks) blocks.push_back(block.area);
        for (const Polygon& cell : v.cells) cells.push_back(signedArea(cell));
        std::sort(blocks.begin(), blocks.end());
        std::sort(cells.begin(), cells.end());
        for (std::size_t i = 0; i < cells.size(); ++i) EXPECT_NEAR(blocks[i], cells[i], 1e-6);  // tolerance × perimeter
    }
}

TEST(Voronoi, TheEstimateForeseesTheWork) {
    EXPECT_EQ(voronoiEstimate(square, 1.0), 100.0);
    EXPECT_EQ(voronoiEstimate(square, 100.0), 1.0);
    EXPECT_GT(voronoiEstimate(square, 1e-6), 1e13);
}

TEST(SiteCells, OfAGridAreItsSquares) {
    // Four sites on one circle everywhere: the corners of each square fall together.
    std::vector<Point> sites;
    for (int i = 0; i < 12; ++i)
        for (int j = 0; j < 9; ++j) sites.push_back({0.1 * i, 0.1 * j});
    const SiteCells cells = siteCells(sites, {{-0.05, -0.05}, {1.15, 0.85}}, 0.1, tolerance);
    EXPECT_EQ(cells.corners.size(), 13 * 10);
    for (std::size_t i = 0; i < sites.size(); ++i) {
        Polygon cell;
        for (const int corner : cells.rings[i]) cell.push_back(cells.corners[corner]);
        ASSERT_EQ(cell.size(), 4u);
        EXPECT_NEAR(signedArea(cell), 0.01, 1e-15);
        EXPECT_LT((moments(cell).centroid - sites[i]).norm(), 1e-15);
    }
}

TEST(SiteCells, OfACircleOfSitesMeetInItsCentre) {
    std::vector<Point> sites;
    for (int i = 0; i < 40; ++i) sites.push_back(directionOf(9.0 * i));
    const SiteCells cells = siteCells(sites, {{-3, -3}, {3, 3}}, 0.15, tolerance);
    const int centre = PointSet(cells.corners).number({0, 0});
    EXPECT_LT(centre, cells.corners.size());
    double area = 0.0;
    for (const std::vector<int>& ring : cells.rings) {
        EXPECT_EQ(std::count(ring.begin(), ring.end(), centre), 1);
        Polygon cell;
        for (const int corner : ring) cell.push_back(cells.corners[corner]);
        area += signedArea(cell);
    }
    EXPECT_NEAR(area, 36.0, 1e-12);
}

TEST(SiteCells, OfSitesOnALineAreStrips) {
    const std::vector<Point> sites{{0, 0}, {1, 1}, {2, 2}, {5, 5}};
    const SiteCells cells = siteCells(sites, {{-10, -10}, {10, 10}}, 1.0, tolerance);
    double area = 0.0;
    for (const std::vector<int>& ring : cells.rings) {
        Polygon cell;
        for (const int corner : ring) cell.push_back(cells.corners[corner]);
        area += signedArea(cell);
    }
    EXPECT_NEAR(area, 400.0, 1e-12);
}

}  // namespace
}  // namespace keyblock
