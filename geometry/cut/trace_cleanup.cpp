// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/cut/trace_cleanup.h"

#include "geometry/cut/near_ends.h"
#include "geometry/segment.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>

namespace keyblock {
namespace {

bool lower(const Point& a, const Point& b) { return std::pair(a.x(), a.y()) < std::pair(b.x(), b.y()); }

/// Puts the lower end of each trace first and sorts the traces by source, then by position, so that the result does not
/// depend on the order of the input.
void sortTraces(std::vector<CutTrace>& traces) {
    for (CutTrace& trace : traces)
        if (lower(trace.to, trace.from)) std::swap(trace.from, trace.to);
    const auto key = [](const CutTrace& trace) {
        return std::tuple(trace.source, trace.from.x(), trace.from.y(), trace.to.x(), trace.to.y());
    };
    std::sort(traces.begin(), traces.end(), [&](const auto& a, const auto& b) { return key(a) < key(b); });
}

/// The part of a trace within a box; ends inside the box are not changed. None if the trace misses the box.
std::optional<CutTrace> inBox(const CutTrace& trace, const Box& box) {
    const Point way = trace.to - trace.from;
    double first = 0.0, last = 1.0;
    for (int axis = 0; axis < 2; ++axis) {
        const double toMin = box.min[axis] - trace.from[axis], toMax = box.max[axis] - trace.from[axis];
        if (way[axis] == 0.0) {
            if (toMin > 0.0 || toMax < 0.0) return std::nullopt;
            continue;
        }
        first = std::max(first, std::min(toMin / way[axis], toMax / way[axis]));
        last = std::min(last, std::max(toMin / way[axis], toMax / way[axis]));
    }
    if (!(first <= last)) return std::nullopt;
    CutTrace part = trace;
    if (last < 1.0) part.to = trace.from + last * way;
    if (first > 0.0) part.from = trace.from + first * way;
    return part;
}

/// A piece that is still given by the numbers of its end positions.
struct Stretch {
    PlacePair ends;
    int source = borderSource;
    int domain = -1;  // of a border edge; −1 for a trace
};

class Cleaner {
public:
    Cleaner(std::span<const CutDomain> domains, const Box& box, double tolerance)
        : domains_(domains), box_(box), tolerance_(tolerance) {}

    CleanTraces clean(std::vector<CutTrace> traces) {
        sortTraces(traces);
        gatherEnds(clipped(traces));
        joinCoincident();
        makePieces();
        pullEnds();
        for (std::size_t i = 0; i < result_.pieces.size(); ++i) {
            const TracePiece& piece = result_.pieces[i];
            const int domain = i < stretches_.size() ? stretches_[i].domain : -1;
            result_.segments.push_back({piece.from, piece.to, {static_cast<int>(i), {domain, -1}}});
        }
        return std::move(result_);
    }

private:
    void note(CutNoteKind kind, const Point& place, int source, int other, double measure) {
        result_.notes.push_back({kind, place, source, other, measure});
    }
    const Point& at(int place) const { return places_[place]; }
    bool nearBox(const Point& p) const { return meets(grown(box_, tolerance_), {p, p}); }

    /// The traces without those that miss the domains. Only traces that extend far outside are clipped, because
    /// clipping rotates them slightly by round-off.
    std::vector<CutTrace> clipped(const std::vector<CutTrace>& traces) {
        const double size = (box_.max - box_.min).maxCoeff();
        const Box close = grown(box_, std::max(8.0 * tolerance_, 1e-3 * size)), far = grown(box_, 0.5 * size);
        std::vector<CutTrace> parts;
        for (const CutTrace& trace : traces) {
            const auto part = inBox(trace, close);
            const Box own{trace.from.cwiseMin(trace.to), trace.from.cwiseMax(trace.to)};
            const bool reachesOut =
                (own.min.array() < far.min.array()).any() || (own.max.array() > far.max.array()).any();
            if (part) parts.push_back(reachesOut ? *part : trace);
            else
                note(CutNoteKind::DroppedOutside, trace.from, trace.source, borderSource,
                     (trace.to - trace.from).norm());
        }
        return parts;
    }

    void gatherEnds(const std::vector<CutTrace>& traces) {
        std::vector<Point> points;
        for (const CutDomain& domain : domains_)
            points.insert(points.end(), domain.outline.begin(), domain.outline.end());
        const std::size_t corners = points.size();
        // sorted by position, so that no end depends on the order of the sources
        std::vector<std::pair<Point, std::size_t>> ends;
        for (std::size_t i = 0; i < traces.size(); ++i) {
            ends.emplace_back(traces[i].from, 2 * i);
            ends.emplace_back(traces[i].to, 2 * i + 1);
        }
        std::sort(ends.begin(), ends.end(), [](const auto& a, const auto& b) {
            return std::tuple(a.first.x(), a.first.y(), a.second) < std::tuple(b.first.x(), b.first.y(), b.second);
        });
        for (const auto& end : ends) points.push_back(end.first);
        Gathered gathered = gather(points, corners, tolerance_);
        places_ = std::move(gathered.places);
        addBorder(gathered.placeOf);
        std::vector<int> placeOfEnd(ends.size());
        for (std::size_t k = 0; k < ends.size(); ++k)
            placeOfEnd[ends[k].second] = gathered.placeOf[corners + k];
        for (std::size_t i = 0; i < traces.size(); ++i) addTrace(traces[i], placeOfEnd[2 * i], placeOfEnd[2 * i + 1]);
        dropRepeated();
    }

    void addBorder(const std::vector<int>& placeOf) {
        std::size_t corner = 0;
        for (std::size_t d = 0; d < domains_.size(); ++d) {
            const std::size_t count = domains_[d].outline.size();
            for (std::size_t i = 0; i < count; ++i)
                stretches_.push_back({{placeOf[corner + i], placeOf[corner + (i + 1) % count]}, borderSource,
                                      static_cast<int>(d)});
            corner += count;
        }
        borders_ = stretches_.size();
    }

    void addTrace(const CutTrace& trace, int from, int to) {
        if (from == to) {
            note(CutNoteKind::DroppedShort, trace.from, trace.source, borderSource, (trace.to - trace.from).norm());
            return;
        }
        for (const auto& [end, place] : {std::pair(trace.from, from), std::pair(trace.to, to)})
            if (at(place) != end && nearBox(end))
                note(CutNoteKind::MovedEnd, end, trace.source, borderSource, (at(place) - end).norm());
        stretches_.push_back({{from, to}, trace.source, -1});
    }

    /// Of several segments between the same two positions only the first is kept; all segments of borders are kept.
    void dropRepeated() {
        std::vector<std::tuple<int, int, int>> keys;  // positions, segment
        for (std::size_t i = 0; i < stretches_.size(); ++i) {
            const PlacePair& ends = stretches_[i].ends;
            keys.emplace_back(std::min(ends.from, ends.to), std::max(ends.from, ends.to), static_cast<int>(i));
        }
        std::sort(keys.begin(), keys.end());
        std::vector<char> repeated(stretches_.size(), 0);
        std::size_t first = 0;
        for (std::size_t k = 1; k < keys.size(); ++k) {
            const auto& [low, high, own] = keys[k];
            if (std::get<0>(keys[first]) != low || std::get<1>(keys[first]) != high) first = k;
            else if (const std::size_t later = own; later >= borders_) {
                const std::size_t earlier = std::get<2>(keys[first]);
                repeated[later] = 1;
                note(CutNoteKind::MergedTrace, 0.5 * (at(low) + at(high)), stretches_[later].source,
                     stretches_[earlier].source, (at(high) - at(low)).norm());
            }
        }
        std::size_t kept = 0;
        for (std::size_t i = 0; i < stretches_.size(); ++i)
            if (!repeated[i]) stretches_[kept++] = stretches_[i];
        stretches_.resize(kept);
    }

    std::vector<PlacePair> links() const {
        std::vector<PlacePair> pairs;
        for (const Stretch& stretch : stretches_) pairs.push_back(stretch.ends);
        return pairs;
    }

    /// Lists the segments that end at each position, one list after another.
    void listStretches() {
        listStart_.assign(places_.size() + 1, 0);
        for (const Stretch& stretch : stretches_)
            for (int place : {stretch.ends.from, stretch.ends.to}) ++listStart_[place + 1];
        for (std::size_t i = 1; i < listStart_.size(); ++i) listStart_[i] += listStart_[i - 1];
        list_.resize(2 * stretches_.size());
        std::vector<int> next(listStart_.begin(), listStart_.end() - 1);
        for (std::size_t i = 0; i < stretches_.size(); ++i)
            for (int place : {stretches_[i].ends.from, stretches_[i].ends.to})
                list_[next[place]++] = static_cast<int>(i);
    }
    std::span<const int> endingAt(int place) const {
        const std::size_t p = place;
        return std::span(list_).subspan(listStart_[p],
                                        static_cast<std::size_t>(listStart_[p + 1] - listStart_[p]));
    }

    /// Pairs (later, earlier) of segments that may coincide in part: an end of one is close to the other.
    std::vector<std::pair<int, int>> coincidentPairs() {
        listStretches();
        std::vector<std::pair<int, int>> pairs;
        for (const auto& [place, stretch] : nearPairs(places_, links(), box_, 2.0 * tolerance_))
            for (int other : endingAt(place))
                if (static_cast<std::size_t>(std::max(stretch, other)) >= borders_)
                    pairs.emplace_back(std::max(stretch, other), std::min(stretch, other));
        std::sort(pairs.begin(), pairs.end());
        pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
        return pairs;
    }

    /// The parts of `later` that do not coincide with `earlier`; nullopt if it stays unchanged.
    std::optional<std::vector<Stretch>> beside(const Stretch& later, const Stretch& earlier) {
        const Point &a = at(earlier.ends.from), &b = at(earlier.ends.to);
        const double length = (b - a).norm();
        const Point along = (b - a) / length;
        struct End {
            int place;
            double s, off;
        };
        const auto seen = [&](int place) { return End{place, along.dot(at(place) - a), cross(along, at(place) - a)}; };
        End low = seen(later.ends.from), high = seen(later.ends.to);
        if (low.s > high.s) std::swap(low, high);
        const double first = std::max(0.0, low.s), last = std::min(length, high.s);
        if (last - first <= 2.0 * tolerance_) return std::nullopt;
        const double slope = (high.off - low.off) / (high.s - low.s);
        const double farthest = tolerance_ * (1.0 + 1e-9);
        if (std::abs(low.off + (first - low.s) * slope) > farthest) return std::nullopt;
        if (std::abs(low.off + (last - low.s) * slope) > farthest) return std::nullopt;
        note(CutNoteKind::MergedTrace, a + 0.5 * (first + last) * along, later.source, earlier.source, last - first);
        std::vector<Stretch> left;
        if (low.s < 0.0 && low.place != earlier.ends.from)
            left.push_back({{low.place, earlier.ends.from}, later.source, -1});
        if (high.s > length && high.place != earlier.ends.to)
            left.push_back({{earlier.ends.to, high.place}, later.source, -1});
        return left;
    }

    void joinCoincident() {
        const std::vector<std::pair<int, int>> pairs = coincidentPairs();
        std::vector<std::vector<Stretch>> left(stretches_.size());  // of each segment
        auto pair = pairs.begin();
        for (std::size_t i = 0; i < stretches_.size(); ++i) {
            left[i] = {stretches_[i]};
            for (; pair != pairs.end() && static_cast<std::size_t>(pair->first) == i; ++pair)
                for (const Stretch& earlier : left[pair->second]) {
                    std::vector<Stretch> rest;
                    for (const Stretch& own : left[i])
                        if (const auto parts = beside(own, earlier))
                            rest.insert(rest.end(), parts->begin(), parts->end());
                        else rest.push_back(own);
                    left[i] = std::move(rest);
                }
        }
        stretches_.clear();
        for (const auto& parts : left) stretches_.insert(stretches_.end(), parts.begin(), parts.end());
        dropRepeated();
    }

    void makePieces() {
        for (const Stretch& stretch : stretches_)
            result_.pieces.push_back({at(stretch.ends.from), at(stretch.ends.to), stretch.source, 0.0, 0.0, false});
    }

    /// A position relative to a segment close to it.
    struct View {
        Point along{1.0, 0.0};  // of the segment
        double length = 0.0;  // of the segment [m]
        double s = 0.0, off = 0.0;  // the position along the segment and to the left of it [m]
    };

    View viewOf(int place, const Stretch& target) const {
        const Point chord = at(target.ends.to) - at(target.ends.from), p = at(place) - at(target.ends.from);
        View view;
        view.length = chord.norm();
        view.along = chord / view.length;
        view.s = view.along.dot(p);
        view.off = cross(view.along, p);
        return view;
    }

    int farEnd(int stretch, int place) const {
        const PlacePair& ends = stretches_[stretch].ends;
        return ends.from == place ? ends.to : ends.from;
    }

    /// True if the segments that end at the position cross the target there anyway.
    bool isAcross(int place, const Stretch& target, const View& view) const {
        bool left = false, right = false;
        for (int own : endingAt(place)) {
            const View far = viewOf(farEnd(own, place), target);
            left = left || far.off > 2.0 * tolerance_;
            right = right || far.off < -2.0 * tolerance_;
            if (std::abs(view.off) <= least() || std::abs(far.off) <= least() || (view.off > 0.0) == (far.off > 0.0))
                continue;
            const double meeting = view.s + (far.s - view.s) * view.off / (view.off - far.off);
            if (meeting > 0.0 && meeting < view.length) return true;
        }
        return left && right;
    }

    double beyond() const { return 0.5 * tolerance_; }  // by which ends are extended past the segment they reach
    double least() const { return 0.125 * tolerance_; }  // distance at which a point is safely on one side

    /// The offset from the target to which the end must be moved: past the target, on the side away from the segment
    /// that ends there.
    double offWanted(int place, const Stretch& target, const View& view) const {
        if (std::abs(view.off) > least()) return view.off > 0.0 ? -beyond() : beyond();
        const double far = cross(view.along, at(farEnd(endingAt(place).front(), place)) - at(target.ends.from));
        return far > 0.0 ? -beyond() : beyond();
    }

    /// Length by which the only segment at a position must be extended to pass the target; none if that is too long or
    /// the segment leads away.
    std::optional<double> goOn(int place, const View& view, double wanted) const {
        const Point& far = at(farEnd(endingAt(place).front(), place));
        const Point way = (at(place) - far).normalized();
        const double rate = cross(view.along, way);
        const double more = (wanted - view.off) / rate;
        if (!(more > 0.0) || more > 4.0 * tolerance_) return std::nullopt;
        const double meeting = view.s - view.off / rate * view.along.dot(way);
        if (meeting < 0.0 || meeting > view.length) return std::nullopt;
        return more;
    }

    void lengthen(int stretch, int place, double more) {
        TracePiece& piece = result_.pieces[stretch];
        const Point way = (at(place) - at(farEnd(stretch, place))).normalized();
        if (stretches_[stretch].ends.from == place) {
            piece.from = at(place) + more * way;
            piece.addedBefore = more;
        } else {
            piece.to = at(place) + more * way;
            piece.addedBehind = more;
        }
    }

    void pullEnd(int place, std::span<const std::pair<int, int>> near) {
        const std::span<const int> own = endingAt(place);
        // Corners of the border are not moved, and neither are ends that lie on them.
        if (own.empty() || static_cast<std::size_t>(own.front()) < borders_) return;
        double more = 0.0;
        for (const auto& [samePlace, other] : near) {
            const Stretch& target = stretches_[other];
            const View view = viewOf(place, target);
            if (isAcross(place, target, view)) continue;
            const int source = stretches_[own.front()].source;
            if (std::abs(view.off) > 1e-3 * tolerance_)
                note(CutNoteKind::PulledEnd, at(place), source, target.source, std::abs(view.off));
            const double wanted = offWanted(place, target, view);
            const auto further = own.size() == 1 ? goOn(place, view, wanted) : std::nullopt;
            if (further) more = std::max(more, *further);
            else
                result_.pieces.push_back({at(place), at(place) + (wanted - view.off) * turnLeft(view.along), source,
                                          0.0, 0.0, true});
        }
        if (more > 0.0) lengthen(own.front(), place, more);
    }

    void pullEnds() {
        listStretches();
        const std::vector<std::pair<int, int>> pairs = nearPairs(places_, links(), box_, tolerance_);
        for (auto first = pairs.begin(); first != pairs.end();) {
            auto last = first;
            while (last != pairs.end() && last->first == first->first) ++last;
            pullEnd(first->first, {first, last});
            first = last;
        }
    }

    std::span<const CutDomain> domains_;
    Box box_;
    double tolerance_;
    std::vector<Point> places_;
    std::vector<Stretch> stretches_;  // border segments first, then by source
    std::size_t borders_ = 0;
    std::vector<int> list_, listStart_;
    CleanTraces result_;
};

}  // namespace

CleanTraces cleanTraces(std::span<const CutDomain> domains, std::vector<CutTrace> traces, const Box& box,
                        double tolerance) {
    return Cleaner(domains, box, tolerance).clean(std::move(traces));
}

}  // namespace keyblock
