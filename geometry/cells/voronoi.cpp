// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// All coordinates are relative to the lower left corner of the region's box. A cell with no edge of the region near it
// is used unchanged. For any other cell, the region is cut by one edge of the cell after the other. Finally, all
// corners are looked up in one set of positions, so that neighbours share the same coordinates.
#include "geometry/cells/voronoi.h"

#include "geometry/cells/site_cells.h"
#include "geometry/cells/split.h"
#include "geometry/grid.h"
#include "geometry/polygon.h"
#include "geometry/random.h"
#include "geometry/segment.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>

namespace keyblock {
namespace {

using Polygon = std::vector<Point>;

long squares(double extent, double size) { return std::max(1L, std::lround(extent / size)); }

/// Divides the region's box into a whole number of squares and puts one random site into each; only sites inside the
/// region are kept.
std::vector<Point> scattered(const Polygon& region, double size, std::uint64_t seed, double tolerance) {
    const Box box = boxOf(region);
    const Point extent = box.max - box.min;
    const long columns = squares(extent.x(), size), rows = squares(extent.y(), size);
    std::vector<Point> sites;
    for (long row = 0; row < rows; ++row)
        for (long column = 0; column < columns; ++column) {
            Random random(seed, {column, row});
            const double x = (static_cast<double>(column) + random.uniform()) / static_cast<double>(columns);
            const double y = (static_cast<double>(row) + random.uniform()) / static_cast<double>(rows);
            const Point site = box.min + extent.cwiseProduct(Point(x, y));
            if (locate(region, site, tolerance) == Side::Inside) sites.push_back(site);
        }
    return sites;
}

/// Intersects the region with convex cells.
class RegionCutter {
public:
    RegionCutter(const Polygon& region, double tolerance)
        : region_(region), tolerance_(tolerance), edges_(boxesOfEdges(region, tolerance)) {}

    /// The parts of a convex cell inside the region. If no edge of the region is near the cell, its first corner
    /// decides whether it lies inside.
    std::vector<Polygon> partsOf(const Polygon& cell) const {
        if (cell.size() < 3) return {};
        if (edges_.meeting(boxOf(cell)).empty()) {
            if (locate(region_, cell.front(), tolerance_) == Side::Outside) return {};
            return {cell};
        }
        std::vector<Polygon> parts{region_};
        for (std::size_t i = 0; i < cell.size(); ++i) {
            const Point along = (cell[(i + 1) % cell.size()] - cell[i]).normalized();
            std::vector<Polygon> left;
            for (const Polygon& part : parts)
                for (Polygon& piece : split(part, cell[i], along, tolerance_).left) left.push_back(std::move(piece));
            parts = std::move(left);
        }
        return parts;
    }

private:
    static std::vector<Box> boxesOfEdges(const Polygon& region, double margin) {
        std::vector<Box> boxes;
        for (std::size_t i = 0; i < region.size(); ++i)
            boxes.push_back(grown(boxOf(Polygon{region[i], region[(i + 1) % region.size()]}), 2.0 * margin));
        return boxes;
    }

    const Polygon& region_;
    double tolerance_;
    BoxGrid edges_;
};

/// The sites and the parts of their cells inside the region; sites without such a part are removed.
struct Parts {
    std::vector<Point> sites;
    std::vector<std::vector<Polygon>> cells;
};

Parts partsOf(const std::vector<Point>& scatteredSites, const Polygon& region, const RegionCutter& cutter, double size,
              double tolerance) {
    PointSet distinct(tolerance);
    for (const Point& site : scatteredSites) distinct.number(site);
    std::vector<Point> sites;
    for (int i = 0; i < distinct.size(); ++i) sites.push_back(distinct[i]);
    const Box box = boxOf(region);
    const double margin = std::min(size, (box.max - box.min).maxCoeff());
    const SiteCells whole = siteCells(sites, grown(box, margin), size, tolerance);
    Parts parts;
    for (std::size_t i = 0; i < sites.size(); ++i) {
        Polygon cell;
        for (const int corner : whole.rings[i]) cell.push_back(whole.corners[corner]);
        std::vector<Polygon> pieces = cutter.partsOf(cell);
        if (pieces.empty()) continue;
        parts.sites.push_back(sites[i]);
        parts.cells.push_back(std::move(pieces));
    }
    return parts;
}

Point centroidOf(const std::vector<Polygon>& pieces) {
    Point sum{0.0, 0.0};
    double area = 0.0;
    for (const Polygon& piece : pieces) {
        const Moments m = moments(piece);
        sum += m.area * m.centroid;
        area += m.area;
    }
    return area > 0.0 ? Point(sum / area) : pieces.front().front();
}

/// A piece as a list of position numbers. Corners of the region on a side of the piece become its corners, because a
/// neighbour may end there.
std::vector<int> ringOf(const Polygon& piece, const Polygon& region, PointSet& places, double tolerance) {
    const Box near = grown(boxOf(piece), tolerance);
    Polygon corners;
    std::copy_if(region.begin(), region.end(), std::back_inserter(corners),
                 [&](const Point& corner) { return meets(near, {corner, corner}); });
    std::vector<int> ring;
    const auto add = [&](int number) {
        if (ring.empty() || ring.back() != number) ring.push_back(number);
    };
    for (std::size_t i = 0; i < piece.size(); ++i) {
        const Point &a = piece[i], &b = piece[(i + 1) % piece.size()];
        add(places.number(a));
        std::vector<std::pair<double, int>> between;
        for (const Point& corner : corners)
            if (distanceToSegment(a, b, corner) <= tolerance)
                between.emplace_back(footParameter(a, b, corner), places.number(corner));
        std::sort(between.begin(), between.end());
        for (const auto& [share, number] : between) add(number);
    }
    while (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
    return ring;
}

/// Sides that two rings share, each listed once.
std::vector<std::pair<int, int>> sharedSides(const std::vector<std::vector<int>>& rings) {
    std::map<std::pair<int, int>, int> count;
    std::vector<std::pair<int, int>> sides;
    for (const std::vector<int>& ring : rings)
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const std::pair<int, int> side = std::minmax(ring[i], ring[(i + 1) % ring.size()]);
            if (++count[side] == 2) sides.push_back(side);
        }
    return sides;
}

VoronoiCells assembled(const Parts& parts, const Polygon& region, const Point& origin, double tolerance) {
    PointSet places(tolerance);
    for (const Point& corner : region) places.number(corner);
    VoronoiCells result;
    std::vector<std::vector<int>> rings;
    for (std::size_t i = 0; i < parts.cells.size(); ++i)
        for (const Polygon& piece : parts.cells[i]) {
            std::vector<int> ring = ringOf(piece, region, places, tolerance);
            if (ring.size() < 3) continue;
            rings.push_back(std::move(ring));
            result.sites.push_back(origin + parts.sites[i]);
        }
    const auto place = [&](int number) { return Point(origin + places[number]); };
    for (const std::vector<int>& ring : rings) {
        Polygon& cell = result.cells.emplace_back();
        for (const int corner : ring) cell.push_back(place(corner));
    }
    for (const auto& [a, b] : sharedSides(rings)) result.edges.push_back({place(a), place(b)});
    return result;
}

}  // namespace

double voronoiEstimate(std::span<const Point> region, double size) {
    assert(!region.empty() && size > 0.0);
    const Box box = boxOf(region);
    return std::max(1.0, (box.max.x() - box.min.x()) / size) * std::max(1.0, (box.max.y() - box.min.y()) / size);
}

VoronoiCells voronoiCells(std::span<const Point> region, double size, std::uint64_t seed, double tolerance) {
    const Point origin = boxOf(region).min;
    Polygon own = counterClockwise({region.begin(), region.end()});
    for (Point& corner : own) corner -= origin;
    const RegionCutter cutter(own, tolerance);
    std::vector<Point> sites = scattered(own, size, seed, tolerance);
    if (sites.empty()) sites.push_back(moments(own).centroid);
    Parts parts = partsOf(sites, own, cutter, size, tolerance);
    for (int move = 0; move < voronoiMoves; ++move) {
        for (std::size_t i = 0; i < parts.sites.size(); ++i) parts.sites[i] = centroidOf(parts.cells[i]);
        parts = partsOf(parts.sites, own, cutter, size, tolerance);
    }
    return assembled(parts, own, origin, tolerance);
}

}  // namespace keyblock
