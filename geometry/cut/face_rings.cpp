// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/cut/face_rings.h"

#include "geometry/grid.h"
#include "geometry/orientation.h"
#include "geometry/polygon.h"

#include <algorithm>
#include <cmath>

namespace keyblock {
namespace {

/// An edge of a ring, given by the numbers of its vertices.
struct RingEdge {
    int from = 0, to = 0;
};

double shoelace(const std::vector<Point>& points, const CutRing& ring) {
    const Point& origin = points[ring.vertices.front()];
    double twice = 0.0;
    for (std::size_t i = 1; i + 1 < ring.vertices.size(); ++i)
        twice += cross(points[ring.vertices[i]] - origin,
                       points[ring.vertices[i + 1]] - origin);
    return 0.5 * twice;
}

double around(const std::vector<Point>& points, const CutRing& ring) {
    double length = 0.0;
    for (std::size_t i = 0; i < ring.vertices.size(); ++i) {
        const std::size_t from = ring.vertices[i];
        const std::size_t to = ring.vertices[(i + 1) % ring.vertices.size()];
        length += (points[to] - points[from]).norm();
    }
    return length;
}

std::vector<Point> outlineOf(const std::vector<Point>& points, const CutRing& ring) {
    std::vector<Point> outline;
    for (int vertex : ring.vertices) outline.push_back(points[vertex]);
    return outline;
}

/// True if the ring lies inside the other. The rings must not cross but may touch at vertices.
bool isInside(const std::vector<Point>& points, const CutRing& ring, const CutRing& other) {
    const std::vector<Point> outline = outlineOf(points, other);
    for (const Point& p : outlineOf(points, ring))
        if (const Side side = locate(outline, p, 0.0); side != Side::Boundary) return side == Side::Inside;
    return false;
}

/// True if a ring turns left at every corner and goes round exactly once. Vertex numbers increase to the right.
bool isConvex(const std::vector<Point>& points, const CutRing& ring) {
    const std::size_t count = ring.vertices.size();
    int tops = 0, lefts = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const int a = ring.vertices[i == 0 ? count - 1 : i - 1], b = ring.vertices[i];
        const int c = ring.vertices[i + 1 == count ? 0 : i + 1];
        const Point &p = points[a], &q = points[b];
        const Point& r = points[c];
        const int way = orientation(p, q, r);
        if (way < 0 || (way == 0 && (q - p).dot(r - q) <= 0.0)) return false;
        lefts += way;
        tops += a < b && c < b;
    }
    return tops == 1 && lefts > 0;
}

/// True if the two edges have no point in common, except possibly a common vertex.
bool areApart(const std::vector<Point>& points, const RingEdge& one, const RingEdge& two) {
    const auto at = [&](int vertex) -> const Point& { return points[vertex]; };
    for (const auto& [a, b] : {std::pair(one.from, one.to), std::pair(one.to, one.from)})
        for (const auto& [c, d] : {std::pair(two.from, two.to), std::pair(two.to, two.from)})
            if (a == c)
                return b != d && (orientation(at(a), at(b), at(d)) != 0 || (at(b) - at(a)).dot(at(d) - at(a)) < 0.0);
    return !segmentsMeet(at(one.from), at(one.to), at(two.from), at(two.to));
}

bool noEdgesMeet(const std::vector<Point>& points, const std::vector<RingEdge>& edges) {
    std::vector<Box> boxes;
    for (const RingEdge& edge : edges) {
        const Point &p = points[edge.from], &q = points[edge.to];
        boxes.push_back({p.cwiseMin(q), p.cwiseMax(q)});
    }
    constexpr std::size_t few = 64;
    if (edges.size() > few) {
        for (const auto& [i, j] : BoxGrid(boxes).meetingPairs())
            if (!areApart(points, edges[i], edges[j])) return false;
        return true;
    }
    for (std::size_t i = 0; i < edges.size(); ++i)
        for (std::size_t j = i + 1; j < edges.size(); ++j)
            if (meets(boxes[i], boxes[j]) && !areApart(points, edges[i], edges[j])) return false;
    return true;
}

void addEdges(const CutRing& ring, std::vector<RingEdge>& edges) {
    for (std::size_t i = 0; i < ring.vertices.size(); ++i)
        edges.push_back({ring.vertices[i], ring.vertices[(i + 1) % ring.vertices.size()]});
}

}  // namespace

RingTracer::RingTracer(const PlanarMap& map, const FaceGroups& groups, std::span<const int> sources, double straight)
    : map_(map), groups_(groups), sources_(sources), straight_(straight), walked_(map.halfEdges.size(), 0),
      place_(map.points.size(), -1), uses_(map.points.size(), 0) {}

TracedGroup RingTracer::trace(int group) {
    walk(group);
    for (const Loop& loop : loops_)
        for (const Corner& corner : loop) ++uses_[corner.vertex];
    std::vector<Loop> straightened;
    for (const Loop& loop : loops_) straightened.push_back(withoutStraight(loop));
    for (const Loop& loop : loops_)
        for (const Corner& corner : loop) uses_[corner.vertex] = 0;
    TracedGroup traced = blocksOf(straightened);
    return traced.sound ? traced : blocksOf(loops_);  // a corner that looks superfluous may keep edges apart
}

void RingTracer::walk(int group) {
    ++walks_;
    loops_.clear();
    groups_.forEachHalfEdge(group, [&](int half) {
        if (walked_[half] != walks_ && groups_.groupAt(half ^ 1) != group) split(half, group);
    });
}

/// Follows one closed line of edges and splits it into loops wherever it returns to a vertex.
void RingTracer::split(int firstHalf, int group) {
    line_.clear();
    int half = firstHalf;
    do {
        walked_[half] = walks_;
        const int from = map_.halfEdges[half ^ 1].target;
        const int to = map_.halfEdges[half].target;
        if (from != to) {
            int& place = place_[from];
            if (place >= 0) closeLoop(static_cast<std::size_t>(place));
            place = static_cast<int>(line_.size());
            line_.push_back({from, map_.marks[half / 2].owner});
        }
        half = map_.halfEdges[half].next;
        while (groups_.groupAt(half ^ 1) == group) half = map_.halfEdges[half ^ 1].next;
    } while (half != firstHalf);
    closeLoop(0);
}

void RingTracer::closeLoop(std::size_t first) {
    for (std::size_t i = first; i < line_.size(); ++i) place_[line_[i].vertex] = -1;
    if (line_.size() - first > 2) loops_.emplace_back(line_.begin() + static_cast<std::ptrdiff_t>(first), line_.end());
    line_.resize(first);
}

/// True if the line from `before` continues straight at `corner`.
bool RingTracer::isStraight(const Corner& before, const Corner& corner, const Corner& after) const {
    if (straight_ < 0.0 || uses_[corner.vertex] > 1) return false;
    if (source(before.owner) != source(corner.owner)) return false;
    const Point &p = at(before.vertex), &q = at(corner.vertex), &r = at(after.vertex);
    return std::abs(cross(r - p, q - p)) <= straight_ * (r - p).norm() && (q - p).dot(r - q) > 0.0;
}

/// Goes round the loop from a corner that is certainly not straight. Each vertex is compared with the last one that was
/// kept, so that a bend spread over several short edges is not lost.
RingTracer::Loop RingTracer::withoutStraight(const Loop& loop) const {
    const std::size_t count = loop.size();
    std::size_t first = 0;
    while (first < count && isStraight(loop[(first + count - 1) % count], loop[first], loop[(first + 1) % count]))
        ++first;
    Loop left;
    for (std::size_t k = 0; k < count; ++k) {
        const std::size_t i = (first + k) % count;
        if (k == 0 || !isStraight(left.back(), loop[i], loop[(i + 1) % count])) left.push_back(loop[i]);
    }
    return left.size() > 2 ? left : loop;
}

/// The ring, starting at the vertex with the lowest number.
CutRing RingTracer::ringOf(const Loop& loop) const {
    const auto lowest = std::min_element(loop.begin(), loop.end(),
                                         [](const Corner& a, const Corner& b) { return a.vertex < b.vertex; });
    CutRing ring;
    ring.vertices.reserve(loop.size());
    ring.sources.reserve(loop.size());
    for (std::size_t i = 0, k = static_cast<std::size_t>(lowest - loop.begin()); i < loop.size(); ++i) {
        ring.vertices.push_back(loop[k].vertex);
        ring.sources.push_back(source(loop[k].owner));
        k = k + 1 == loop.size() ? 0 : k + 1;
    }
    return ring;
}

TracedGroup RingTracer::blocksOf(const std::vector<Loop>& loops) const {
    TracedGroup traced;
    std::vector<CutRing> holes;
    for (const Loop& loop : loops) {
        CutRing ring = ringOf(loop);
        const double area = shoelace(map_.points, ring);
        if (area > 0.0) traced.blocks.push_back({std::move(ring), {}, area, 0.0});
        else holes.push_back(std::move(ring));
    }
    std::sort(holes.begin(), holes.end(), [](const CutRing& a, const CutRing& b) { return a.vertices < b.vertices; });
    traced.sound = true;
    for (CutRing& hole : holes) {
        const auto around = std::find_if(traced.blocks.begin(), traced.blocks.end(), [&](const TracedBlock& block) {
            return traced.blocks.size() == 1 || isInside(map_.points, hole, block.outer);
        });
        if (around == traced.blocks.end()) {
            traced.sound = false;
            break;
        }
        around->area += shoelace(map_.points, hole);
        around->holes.push_back(std::move(hole));
    }
    for (TracedBlock& block : traced.blocks) {
        block.perimeter = around(map_.points, block.outer);
        for (const CutRing& hole : block.holes) block.perimeter += around(map_.points, hole);
        traced.sound = traced.sound && block.area > 0.0 && isSound(block);
    }
    return traced;
}

bool RingTracer::isSound(const TracedBlock& block) const {
    if (block.holes.empty() && isConvex(map_.points, block.outer)) return true;
    std::vector<RingEdge> edges;
    addEdges(block.outer, edges);
    for (const CutRing& hole : block.holes) addEdges(hole, edges);
    return noEdgesMeet(map_.points, edges);
}

}  // namespace keyblock
