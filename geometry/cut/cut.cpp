// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The traces are cleaned in double precision and inserted exactly, faces that are too small are merged with neighbours,
// and the result is rounded and checked again. All coordinates are relative to an origin near the scene, so that a
// scene far from zero loses no accuracy. The steps and their limits: theory, "Cutting".
#include "geometry/cut/cut.h"

#include "geometry/cut/face_groups.h"
#include "geometry/cut/face_rings.h"
#include "geometry/cut/near_ends.h"
#include "geometry/cut/planar_map.h"
#include "geometry/cut/trace_cleanup.h"
#include "geometry/polygon.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>

namespace keyblock {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

bool isUsable(const Point& p) { return std::abs(p.x()) < 1e100 && std::abs(p.y()) < 1e100; }

/// The outline without repeated corners, counter-clockwise, starting at the leftmost corner (the lowest of several).
std::vector<Point> canonical(std::vector<Point> outline) {
    outline.erase(std::unique(outline.begin(), outline.end()), outline.end());
    while (outline.size() > 1 && outline.front() == outline.back()) outline.pop_back();
    if (outline.size() < 3) return {};
    outline = counterClockwise(std::move(outline));
    std::rotate(outline.begin(), std::min_element(outline.begin(), outline.end(), [](const Point& a, const Point& b) {
        return std::pair(a.x(), a.y()) < std::pair(b.x(), b.y());
    }), outline.end());
    return outline;
}

bool isBefore(const CutDomain& a, const CutDomain& b) {
    if (a.id != b.id) return a.id < b.id;
    return std::lexicographical_compare(a.outline.begin(), a.outline.end(), b.outline.begin(), b.outline.end(),
                                        [](const Point& p, const Point& q) {
                                            return std::pair(p.x(), p.y()) < std::pair(q.x(), q.y());
                                        });
}

/// The centre rounded to whole multiples of a power of two, so that subtracting it loses no digits; zero near the
/// origin.
double offsetOf(double center, double size) {
    if (std::abs(center) <= 4.0 * size) return 0.0;
    const double step = std::exp2(std::ceil(std::log2(size)));
    return step * std::round(center / step);
}

class Cutter {
public:
    Cutter(std::span<const CutDomain> domains, std::span<const CutTrace> traces, const CutSettings& settings)
        : settings_(settings) {
        takeDomains(domains);
        takeTraces(traces);
        if (domains_.empty()) return;
        setFrame();
        setTolerance();
    }

    Cut cut() {
        if (!domains_.empty()) {
            clean();
            roundPlaces();
            cutFaces();
        }
        for (CutNote& note : cut_.notes) note.place += origin_;
        std::sort(cut_.notes.begin(), cut_.notes.end(), [](const CutNote& a, const CutNote& b) {
            return std::tuple(a.kind, a.place.x(), a.place.y(), a.source, a.other, a.measure) <
                   std::tuple(b.kind, b.place.x(), b.place.y(), b.source, b.other, b.measure);
        });
        return std::move(cut_);
    }

private:
    void note(CutNoteKind kind, const Point& place, int source, double measure) {
        cut_.notes.push_back({kind, place, source, borderSource, measure});
    }

    void takeDomains(std::span<const CutDomain> domains) {
        for (const CutDomain& domain : domains) {
            if (!std::all_of(domain.outline.begin(), domain.outline.end(), isUsable)) {
                note(CutNoteKind::DroppedNotFinite, {0.0, 0.0}, domain.id, 0.0);
                continue;
            }
            CutDomain own{domain.id, canonical(domain.outline)};
            const Point first = domain.outline.empty() ? Point(0.0, 0.0) : domain.outline.front();
            if (own.outline.empty() || !(boxSide(own.outline) > 1e-100))
                note(CutNoteKind::DroppedDomain, first, domain.id, 0.0);
            else domains_.push_back(std::move(own));
        }
        std::sort(domains_.begin(), domains_.end(), isBefore);
        const auto same = [](const CutDomain& a, const CutDomain& b) { return !isBefore(a, b) && !isBefore(b, a); };
        domains_.erase(std::unique(domains_.begin(), domains_.end(), same), domains_.end());
    }

    static double boxSide(const std::vector<Point>& points) {
        const Box box = boxOf(points);
        return (box.max - box.min).minCoeff();
    }

    void takeTraces(std::span<const CutTrace> traces) {
        traces_.reserve(traces.size());
        for (const CutTrace& trace : traces)
            if (isUsable(trace.from) && isUsable(trace.to)) traces_.push_back(trace);
            else note(CutNoteKind::DroppedNotFinite, {0.0, 0.0}, trace.source, 0.0);
    }

    void setFrame() {
        box_ = boxOf(domains_.front().outline);
        for (const CutDomain& domain : domains_) {
            const Box own = boxOf(domain.outline);
            box_ = {box_.min.cwiseMin(own.min), box_.max.cwiseMax(own.max)};
        }
        farthest_ = std::max(box_.min.cwiseAbs().maxCoeff(), box_.max.cwiseAbs().maxCoeff());
        size_ = (box_.max - box_.min).maxCoeff();
        const Point center = 0.5 * (box_.min + box_.max);
        origin_ = {offsetOf(center.x(), size_), offsetOf(center.y(), size_)};
        box_ = {box_.min - origin_, box_.max - origin_};
        for (CutDomain& domain : domains_)
            for (Point& p : domain.outline) p -= origin_;
        for (CutTrace& trace : traces_) {
            trace.from -= origin_;
            trace.to -= origin_;
        }
        for (CutNote& note : cut_.notes) note.place -= origin_;
    }

    static double atLeastZero(double value) { return value > 0.0 ? value : 0.0; }

    void setTolerance() {
        const double wanted = atLeastZero(settings_.tolerance.value_or(1e-6 * size_));
        cut_.tolerance = std::min(std::max(wanted, 64.0 * epsilon * farthest_), 0.01 * size_);
    }

    /// The given limits, or by default fractions of the mean face area and of its square root.
    void setLeastFaces(const FaceGroups& groups) {
        double area = 0.0;
        int faces = 0;
        for (int face = 1; face < map_.faces; ++face) {
            if (groups.domainOf(face) < 0) continue;
            area += groups.area(face);
            ++faces;
        }
        const double mean = faces > 0 ? area / faces : 0.0;
        cut_.minArea = atLeastZero(settings_.minArea.value_or(1e-3 * mean));
        const double width = std::max(1e-2 * std::sqrt(mean), 10.0 * cut_.tolerance);
        cut_.minWidth = atLeastZero(settings_.minWidth.value_or(width));
    }

    void clean() {
        clean_ = cleanTraces(domains_, std::move(traces_), box_, cut_.tolerance);
        cut_.notes.insert(cut_.notes.end(), clean_.notes.begin(), clean_.notes.end());
        map_ = planarMap(clean_.segments, 16.0 * epsilon * size_);
        for (const TracePiece& piece : clean_.pieces) sources_.push_back(piece.source);
    }

    /// Resolution of coordinates [m].
    double roundOff() const { return std::max(16.0 * epsilon * size_, 2.0 * epsilon * farthest_); }

    /// Rounds the vertices to their output coordinates, merges vertices that differ only by round-off, and sorts them.
    void roundPlaces() {
        std::vector<Point> points;
        for (const CutDomain& domain : domains_)
            points.insert(points.end(), domain.outline.begin(), domain.outline.end());
        const std::size_t corners = points.size();
        for (const Point& p : map_.points) points.push_back(Point(p + origin_) - origin_);
        Gathered gathered = gatherSorted(points, corners, 4.0 * roundOff());
        map_.points = std::move(gathered.places);
        for (HalfEdge& half : map_.halfEdges)
            half.target = gathered.placeOf[corners + half.target];
    }

    void cutFaces() {
        FaceGroups groups(map_);
        setLeastFaces(groups);
        noteLooseEnds(groups);
        for (const Sliver& sliver : joinSlivers(groups, map_.faces, cut_.minArea, cut_.minWidth)) noteSliver(sliver);
        RingTracer tracer(map_, groups, sources_, settings_.keepStraight ? -1.0 : roundOff());
        Blocks blocks;
        std::vector<int> unsound;
        for (int face = 1; face < map_.faces; ++face)
            if (groups.domainOf(face) >= 0 && groups.groupOf(face) == face && !addBlocks(tracer, face, blocks))
                unsound.push_back(face);
        if (!unsound.empty()) joinUnsound(groups, tracer, std::move(unsound), blocks);
        handOut(groups, std::move(blocks));
    }

    using Blocks = std::vector<std::pair<int, TracedBlock>>;  // each with its group

    /// Adds the blocks of a group. \return false, with nothing added, if a block is not sound or if one of several
    /// blocks of the group is below a size limit.
    bool addBlocks(RingTracer& tracer, int group, Blocks& blocks) const {
        TracedGroup traced = tracer.trace(group);
        if (!traced.sound) return false;
        if (traced.blocks.size() > 1)
            for (const TracedBlock& block : traced.blocks)
                if (block.area < cut_.minArea || 2.0 * block.area < cut_.minWidth * block.perimeter) return false;
        for (TracedBlock& block : traced.blocks) blocks.emplace_back(group, std::move(block));
        return true;
    }

    /// Merges groups that rounding made unsound, the smallest first. A group that is larger than one of its neighbours
    /// is merged with the smallest neighbour, which is the likely cause. Any other group is merged with the neighbour
    /// along its longest edge.
    void joinUnsound(FaceGroups& groups, RingTracer& tracer, std::vector<int> unsound,
                     Blocks& blocks) {
        const auto larger = [&](int a, int b) {
            return std::pair(groups.area(a), a) > std::pair(groups.area(b), b);
        };
        while (!unsound.empty()) {
            std::sort(unsound.begin(), unsound.end(), larger);
            const int group = unsound.back();
            unsound.pop_back();
            const auto neighbour = partnerOfUnsound(groups, group);
            if (!neighbour) {
                for (TracedBlock& block : tracer.trace(group).blocks)
                    if (block.area > 0.0) blocks.emplace_back(group, std::move(block));
                continue;
            }
            const HalfEdge& half = map_.halfEdges[2 * static_cast<std::size_t>(neighbour->edge)];
            const int owner = map_.marks[neighbour->edge].owner;
            note(CutNoteKind::MergedUnsound, map_.points[half.target],
                 sources_[owner],
                 std::min(groups.area(group), groups.area(neighbour->group)));
            const int old = neighbour->group, both = groups.join(group, *neighbour);
            std::erase(unsound, old);
            std::erase_if(blocks, [&](const auto& block) { return block.first == old; });
            if (!addBlocks(tracer, both, blocks)) unsound.push_back(both);
        }
    }

    static std::optional<FaceGroups::Neighbour> partnerOfUnsound(const FaceGroups& groups, int group) {
        std::optional<FaceGroups::Neighbour> smallest;
        for (const FaceGroups::Neighbour& one : groups.neighbours(group))
            if (!smallest || groups.area(one.group) < groups.area(smallest->group)) smallest = one;
        if (smallest && groups.area(smallest->group) < groups.area(group)) return smallest;
        return groups.longestNeighbour(group);
    }

    void noteSliver(const Sliver& sliver) {
        const std::size_t end = map_.halfEdges[sliver.halfEdge].target;
        if (sliver.edge < 0) {
            note(CutNoteKind::KeptSliver, map_.points[end], borderSource, sliver.area);
            return;
        }
        const std::size_t e = sliver.edge;
        const Point middle = 0.5 * (map_.points[map_.halfEdges[2 * e].target] +
                                    map_.points[map_.halfEdges[2 * e + 1].target]);
        note(CutNoteKind::MergedSliver, middle, sources_[map_.marks[e].owner], sliver.area);
    }

    /// An interval of a piece that bounds no face; its ends are lengths along the piece.
    struct LooseStretch {
        double first = 0.0, last = 0.0;  // [m]
    };

    void noteLooseEnds(const FaceGroups& groups) {
        struct Edge {
            int piece;
            double first, last;
        };
        std::vector<Edge> loose;
        std::vector<char> bounds(clean_.pieces.size(), 0), seen(clean_.pieces.size(), 0);
        for (std::size_t e = 0; e < map_.marks.size(); ++e) {
            const HalfEdge &one = map_.halfEdges[2 * e], &two = map_.halfEdges[2 * e + 1];
            const int owner = map_.marks[e].owner;
            const std::size_t piece = owner;
            if (sources_[piece] == borderSource || clean_.pieces[piece].bridge) continue;
            seen[piece] = 1;
            const bool inside = groups.domainOf(one.face) >= 0;
            if (one.face != two.face) {
                bounds[piece] = bounds[piece] || inside || groups.domainOf(two.face) >= 0;
                continue;
            }
            if (!inside) continue;
            const auto along = [&](int vertex) {
                const TracePiece& own = clean_.pieces[piece];
                return (own.to - own.from).normalized().dot(map_.points[vertex] - own.from);
            };
            const double from = along(two.target), to = along(one.target);
            loose.push_back({owner, std::min(from, to), std::max(from, to)});
        }
        std::sort(loose.begin(), loose.end(), [](const Edge& a, const Edge& b) {
            return std::tuple(a.piece, a.first, a.last) < std::tuple(b.piece, b.first, b.last);
        });
        auto edge = loose.begin();
        for (std::size_t piece = 0; piece < clean_.pieces.size(); ++piece) {
            std::vector<LooseStretch> stretches;
            for (; edge != loose.end() && static_cast<std::size_t>(edge->piece) == piece; ++edge)
                if (!stretches.empty() && edge->first <= stretches.back().last + 1e-3 * cut_.tolerance)
                    stretches.back().last = edge->last;
                else stretches.push_back({edge->first, edge->last});
            if (seen[piece]) notePiece(clean_.pieces[piece], bounds[piece], stretches);
        }
    }

    void notePiece(const TracePiece& piece, bool bounds, const std::vector<LooseStretch>& loose) {
        const double length = (piece.to - piece.from).norm(), slack = 1e-3 * cut_.tolerance;
        const Point way = (piece.to - piece.from) / length;
        const Point start = piece.from + piece.addedBefore * way, end = piece.to - piece.addedBehind * way;
        double sum = 0.0;
        for (const LooseStretch& stretch : loose) {
            const double first = std::max(stretch.first, piece.addedBefore);
            const double last = std::min(stretch.last, length - piece.addedBehind);
            if (last - first <= slack) continue;
            sum += last - first;
            if (!bounds) continue;
            if (stretch.first <= slack) note(CutNoteKind::TrimmedEnd, start, piece.source, last - first);
            else if (stretch.last >= length - slack) note(CutNoteKind::TrimmedEnd, end, piece.source, last - first);
            else note(CutNoteKind::TrimmedStretch, piece.from + 0.5 * (first + last) * way, piece.source, last - first);
        }
        if (bounds) return;
        if (sum > 0.0) note(CutNoteKind::DroppedLoose, start, piece.source, sum);
        else note(CutNoteKind::DroppedOutside, start, piece.source, length - piece.addedBefore - piece.addedBehind);
    }

    void handOut(const FaceGroups& groups, Blocks blocks) {
        const auto domainOf = [&](int face) { return domains_[groups.domainOf(face)].id; };
        std::vector<std::size_t> order(blocks.size());
        std::iota(order.begin(), order.end(), 0u);
        std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
            const int first = domainOf(blocks[a].first), second = domainOf(blocks[b].first);
            if (first != second) return first < second;
            return blocks[a].second.outer.vertices < blocks[b].second.outer.vertices;
        });
        std::vector<int> index(map_.points.size(), -1);
        const auto forEachVertex = [](TracedBlock& block, auto visit) {
            for (int& vertex : block.outer.vertices) visit(vertex);
            for (CutRing& hole : block.holes)
                for (int& vertex : hole.vertices) visit(vertex);
        };
        for (auto& block : blocks)
            forEachVertex(block.second, [&](int vertex) { index[vertex] = 0; });
        for (std::size_t vertex = 0; vertex < index.size(); ++vertex)
            if (index[vertex] == 0) {
                index[vertex] = static_cast<int>(cut_.vertices.size());
                cut_.vertices.push_back(map_.points[vertex] + origin_);
            }
        cut_.blocks.reserve(blocks.size());
        for (std::size_t i : order) {
            TracedBlock& block = blocks[i].second;
            forEachVertex(block, [&](int& vertex) { vertex = index[vertex]; });
            cut_.blocks.push_back({domainOf(blocks[i].first), std::move(block.outer), std::move(block.holes),
                                   block.area, 2.0 * block.area / block.perimeter});
        }
    }

    CutSettings settings_;
    std::vector<CutDomain> domains_;
    std::vector<CutTrace> traces_;
    Box box_;
    Point origin_{0.0, 0.0};  // [m]
    double size_ = 0.0, farthest_ = 0.0;  // [m]
    CleanTraces clean_;
    PlanarMap map_;
    std::vector<int> sources_;  // of each piece
    Cut cut_;
};

}  // namespace

Cut cutIntoBlocks(std::span<const CutDomain> domains, std::span<const CutTrace> traces, const CutSettings& settings) {
    return Cutter(domains, traces, settings).cut();
}

}  // namespace keyblock
