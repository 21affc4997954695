// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/cells/sub_blocks.h"

#include "geometry/cells/split.h"
#include "geometry/grid.h"
#include "geometry/polygon.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

namespace keyblock {
namespace {

using Polygon = std::vector<Point>;

/// The frame of the grid: rows run along `along`, and `box` is the bounding box of the outline in this frame.
struct Grid {
    Point along{1.0, 0.0};
    Box box;
    int columns = 1, rows = 1;

    double width() const { return (box.max.x() - box.min.x()) / columns; }
    double height() const { return (box.max.y() - box.min.y()) / rows; }
};

/// The direction, rotated by quarter turns until it points mostly to the right.
Point rightmost(Point direction) {
    constexpr double even = 1e-9;  // of two diagonal directions, the rising one is taken
    for (int quarter = 0; quarter < 4; ++quarter) {
        if (direction.x() > 0.0 && direction.y() <= direction.x() * (1.0 + even) &&
            direction.y() > -direction.x() * (1.0 - even))
            break;
        direction = turnLeft(direction);
    }
    return direction;
}

/// Direction of the longest edge; of several equally long ones, the edge that rotates the grid least.
Point gridDirection(std::span<const Point> polygon) {
    constexpr double equal = 1e-9;
    double longest = 0.0;
    for (std::size_t i = 0; i < polygon.size(); ++i)
        longest = std::max(longest, (polygon[(i + 1) % polygon.size()] - polygon[i]).norm());
    std::optional<Point> best;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Point edge = polygon[(i + 1) % polygon.size()] - polygon[i];
        if (edge.norm() < longest * (1.0 - equal)) continue;
        const Point direction = rightmost(edge.normalized());
        if (!best || std::abs(direction.y()) < std::abs(best->y()) - equal) best = direction;
    }
    return *best;
}

Point inFrame(const Point& p, const Point& along) { return {along.dot(p), cross(along, p)}; }
Point fromFrame(const Point& p, const Point& along) { return p.x() * along + p.y() * turnLeft(along); }

Polygon allInFrame(std::span<const Point> polygon, const Point& origin, const Point& along) {
    Polygon own;
    for (const Point& p : polygon) own.push_back(inFrame(p - origin, along));
    return counterClockwise(std::move(own));
}

int wholeCells(double length, double size) { return std::max(1, static_cast<int>(std::lround(length / size))); }

Grid gridOf(const Polygon& inFrame, const Point& along, double size) {
    Grid grid;
    grid.along = along;
    grid.box = boxOf(inFrame);
    grid.columns = wholeCells(grid.box.max.x() - grid.box.min.x(), size);
    grid.rows = wholeCells(grid.box.max.y() - grid.box.min.y(), size);
    return grid;
}

/// Cuts the pieces by `count − 1` lines along `direction` through `first + i·step` and passes each part to `done`, with
/// the number of its strip.
template <class Done>
void slice(std::vector<Polygon> rest, const Point& first, const Point& step, const Point& direction, int count,
           double tolerance, Done done) {
    for (int i = 1; i < count; ++i) {
        std::vector<Polygon> beyond;
        for (const Polygon& piece : rest) {
            Split parts = split(piece, first + i * step, direction, tolerance);
            for (Polygon& part : parts.right) done(i - 1, std::move(part));
            for (Polygon& part : parts.left) beyond.push_back(std::move(part));
        }
        rest = std::move(beyond);
    }
    for (Polygon& piece : rest) done(count - 1, std::move(piece));
}

std::vector<Polygon> cellsOf(const Polygon& outline, const Grid& grid, double tolerance) {
    std::vector<std::vector<Polygon>> columns(grid.columns);
    // downwards, so that the remaining columns lie on the left of each line
    slice({outline}, grid.box.min, {grid.width(), 0.0}, {0.0, -1.0}, grid.columns, tolerance,
          [&](int column, Polygon part) { columns[column].push_back(std::move(part)); });
    std::vector<Polygon> cells;
    for (std::vector<Polygon>& column : columns) {
        std::vector<std::vector<Polygon>> rows(grid.rows);
        slice(std::move(column), grid.box.min, {0.0, grid.height()}, {1.0, 0.0}, grid.rows, tolerance,
              [&](int row, Polygon part) { rows[row].push_back(std::move(part)); });
        for (std::vector<Polygon>& row : rows) {
            std::sort(row.begin(), row.end(), [](const Polygon& a, const Polygon& b) {
                const Point p = moments(a).centroid, q = moments(b).centroid;
                return std::pair(p.x(), p.y()) < std::pair(q.x(), q.y());
            });
            for (Polygon& cell : row) cells.push_back(std::move(cell));
        }
    }
    return cells;
}

/// Parts of edges that `a` shares with `b`, in the direction of `a`.
std::vector<std::pair<Point, Point>> sharedBy(const Polygon& a, const Polygon& b, double tolerance) {
    std::vector<std::pair<Point, Point>> pieces;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const Point from = a[i], chord = a[(i + 1) % a.size()] - from;
        const double length = chord.norm();
        const Point along = chord / length;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const Point p = b[j] - from, q = b[(j + 1) % b.size()] - from;
            if (std::abs(cross(along, p)) > tolerance || std::abs(cross(along, q)) > tolerance) continue;
            const double s0 = std::max(0.0, along.dot(q)), s1 = std::min(length, along.dot(p));
            if (s1 - s0 > tolerance) pieces.emplace_back(from + s0 * along, from + s1 * along);
        }
    }
    return pieces;
}

double lengthOf(const std::vector<std::pair<Point, Point>>& pieces) {
    double length = 0.0;
    for (const auto& [from, to] : pieces) length += (to - from).norm();
    return length;
}

/// The polygon, with added corners where a corner of the other polygon lies on one of its edges.
Polygon withCornersOf(const Polygon& polygon, const Polygon& other, double tolerance) {
    Polygon all;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Point& from = polygon[i];
        const Point chord = polygon[(i + 1) % polygon.size()] - from;
        const double length = chord.norm();
        const Point along = chord / length;
        std::vector<double> places;
        for (const Point& p : other) {
            const double s = along.dot(p - from);
            if (s > tolerance && s < length - tolerance && std::abs(cross(along, p - from)) <= tolerance)
                places.push_back(s);
        }
        std::sort(places.begin(), places.end());
        all.push_back(from);
        for (double s : places) all.push_back(from + s * along);
    }
    return all;
}

/// The polygon without those corners among `ends` at which the outline is straight within round-off.
Polygon withoutStraight(const Polygon& polygon, const std::vector<Point>& ends, double tolerance) {
    Polygon left;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Point& p = polygon[i];
        const Point& before = polygon[(i + polygon.size() - 1) % polygon.size()];
        const Point& after = polygon[(i + 1) % polygon.size()];
        const bool isEnd = std::any_of(ends.begin(), ends.end(),
                                       [&](const Point& end) { return (end - p).norm() <= tolerance; });
        const double turn = cross(p - before, after - p) / ((p - before).norm() * (after - p).norm());
        if (!isEnd || std::abs(turn) > 1e-9) left.push_back(p);
    }
    return left;
}

/// The union of both polygons; nothing if it would have a hole or a pinch.
std::optional<Polygon> joined(const Polygon& first, const Polygon& second, double tolerance) {
    const Polygon a = withCornersOf(first, second, tolerance), b = withCornersOf(second, first, tolerance);
    const auto same = [&](const Point& p, const Point& q) { return (p - q).norm() <= 2.0 * tolerance; };
    struct Piece {
        Point from{0.0, 0.0}, to{0.0, 0.0};
        bool used = false;
    };
    std::vector<Piece> pieces;
    std::vector<Point> ends;  // of shared edges; the outline may be straight there
    const auto add = [&](const Polygon& own, const Polygon& other) {
        for (std::size_t i = 0; i < own.size(); ++i) {
            const Point &p = own[i], &q = own[(i + 1) % own.size()];
            bool inner = false;
            for (std::size_t j = 0; j < other.size() && !inner; ++j)
                inner = same(other[j], q) && same(other[(j + 1) % other.size()], p);
            if (!inner) pieces.push_back({p, q});
            else ends.insert(ends.end(), {p, q});
        }
    };
    add(a, b);
    add(b, a);
    if (pieces.empty()) return std::nullopt;
    Polygon outline;
    std::size_t at = 0, walked = 0;
    while (!pieces[at].used) {
        pieces[at].used = true;
        ++walked;
        outline.push_back(pieces[at].from);
        std::size_t next = pieces.size(), ways = 0;
        for (std::size_t k = 0; k < pieces.size(); ++k)
            if (same(pieces[k].from, pieces[at].to)) next = k, ++ways;
        if (ways != 1) return std::nullopt;
        at = next;
    }
    if (walked != pieces.size() || at != 0) return std::nullopt;
    return withoutStraight(outline, ends, 2.0 * tolerance);
}

/// The cells adjacent to each cell.
std::vector<std::vector<int>> neighbours(const std::vector<Polygon>& cells, double tolerance) {
    std::vector<Box> boxes;
    for (const Polygon& cell : cells) boxes.push_back(grown(boxOf(cell), tolerance));
    std::vector<std::vector<int>> beside(cells.size());
    for (const auto& [i, j] : BoxGrid(std::move(boxes)).meetingPairs()) {
        beside[i].push_back(j);
        beside[j].push_back(i);
    }
    return beside;
}

/// Joins each sliver, the smallest first, to the neighbour with which it shares the longest boundary.
void joinSlivers(std::vector<Polygon>& cells, double leastArea, double tolerance) {
    const std::vector<std::vector<int>> beside = neighbours(cells, tolerance);
    std::vector<int> owner(cells.size());  // the cell into which each piece was merged
    std::iota(owner.begin(), owner.end(), 0);
    std::vector<std::vector<int>> parts(cells.size());  // pieces merged into each cell, including itself
    for (std::size_t i = 0; i < cells.size(); ++i) parts[i] = {static_cast<int>(i)};
    std::vector<std::pair<double, int>> slivers;
    for (std::size_t i = 0; i < cells.size(); ++i)
        if (const double area = signedArea(cells[i]); area < leastArea) slivers.emplace_back(area, static_cast<int>(i));
    std::sort(slivers.begin(), slivers.end());
    for (const auto& sliver : slivers) {
        const std::size_t own = sliver.second;
        if (cells[own].empty() || signedArea(cells[own]) >= leastArea) continue;
        std::vector<std::pair<double, int>> choices;
        for (int part : parts[own])
            for (int k : beside[part]) {
                const int other = owner[k];
                if (other == sliver.second) continue;
                const double length = lengthOf(sharedBy(cells[own], cells[other], 4.0 * tolerance));
                if (length > 0.0) choices.emplace_back(-length, other);
            }
        std::sort(choices.begin(), choices.end());
        choices.erase(std::unique(choices.begin(), choices.end()), choices.end());
        for (const auto& choice : choices) {
            const std::size_t other = choice.second;
            std::optional<Polygon> both = joined(cells[other], cells[own], 4.0 * tolerance);
            if (!both) continue;
            cells[other] = std::move(*both);
            cells[own].clear();
            for (int part : parts[own]) owner[part] = choice.second;
            parts[other].insert(parts[other].end(), parts[own].begin(), parts[own].end());
            break;
        }
    }
    std::erase_if(cells, [](const Polygon& cell) { return cell.empty(); });
}

std::vector<SharedEdge> sharedEdges(const std::vector<Polygon>& cells, double tolerance) {
    std::vector<Box> boxes;
    for (const Polygon& cell : cells) boxes.push_back(grown(boxOf(cell), tolerance));
    std::vector<SharedEdge> shared;
    for (const auto& [i, j] : BoxGrid(std::move(boxes)).meetingPairs())
        for (const auto& [from, to] :
             sharedBy(cells[i], cells[j], 4.0 * tolerance))
            shared.push_back({i, j, from, to});
    return shared;
}

}  // namespace

double gridCells(std::span<const Point> polygon, double size) {
    const Point along = gridDirection(polygon);
    const Box box = boxOf(allInFrame(polygon, polygon.front(), along));
    const Point cells = ((box.max - box.min) / size).cwiseMax(1.0);
    return cells.x() * cells.y();
}

SubBlocks cutIntoCells(std::span<const Point> polygon, double size, double tolerance) {
    assert(size > 0.0);
    const Point along = gridDirection(polygon), origin = polygon.front();
    const Polygon outline = allInFrame(polygon, origin, along);
    const Grid grid = gridOf(outline, along, size);
    SubBlocks result;
    result.cellArea = grid.width() * grid.height();
    result.cells = cellsOf(outline, grid, tolerance);
    joinSlivers(result.cells, leastCellShare * result.cellArea, tolerance);
    result.shared = sharedEdges(result.cells, tolerance);
    for (Polygon& cell : result.cells)
        for (Point& p : cell) p = origin + fromFrame(p, along);
    for (SharedEdge& edge : result.shared) {
        edge.from = origin + fromFrame(edge.from, along);
        edge.to = origin + fromFrame(edge.to, along);
    }
    return result;
}

}  // namespace keyblock
