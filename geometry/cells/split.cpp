// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The line divides the outline into chains on either side. Just above the line, every end of a chain is a change from
// inside to outside or back. So the ends, in their order along the line, are joined in pairs, which closes the chains
// into pieces.
#include "geometry/cells/split.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace keyblock {
namespace {

/// A corner and its position relative to the line; `off` is exactly 0 on the line.
struct ChainCorner {
    Point p{0.0, 0.0};
    double along = 0.0, off = 0.0;
};

/// The corners of the polygon, and a corner wherever an edge crosses the line.
std::vector<ChainCorner> cornersAndCrossings(std::span<const Point> polygon, const Point& place, const Point& along,
                                        double tolerance) {
    std::vector<ChainCorner> own;
    for (const Point& p : polygon) {
        const double off = cross(along, p - place);
        own.push_back({p, along.dot(p - place), std::abs(off) <= tolerance ? 0.0 : off});
    }
    std::vector<ChainCorner> all;
    for (std::size_t i = 0; i < own.size(); ++i) {
        const ChainCorner& a = own[i];
        const ChainCorner& b = own[(i + 1) % own.size()];
        all.push_back(a);
        if (a.off * b.off >= 0.0) continue;
        const double share = a.off / (a.off - b.off);
        const double s = a.along + share * (b.along - a.along);
        all.push_back({place + s * along, s, 0.0});
    }
    return all;
}

struct Chain {
    std::vector<ChainCorner> corners;  // the first and the last lie on the line
};

/// The parts of the outline on the positive side. If the outline never leaves that side, `whole` is set and the result
/// is empty.
std::vector<Chain> chainsAbove(const std::vector<ChainCorner>& corners, bool& whole) {
    const std::size_t n = corners.size();
    const auto above = [&](std::size_t i) { return corners[i % n].off > 0.0 || corners[(i + 1) % n].off > 0.0; };
    std::size_t start = 0;  // an edge that is not above the line
    while (start < n && above(start)) ++start;
    whole = start == n;
    std::vector<Chain> chains;
    for (std::size_t k = 1; !whole && k <= n; ++k) {
        const std::size_t edge = start + k;
        if (!above(edge)) continue;
        if (!above(edge - 1) || corners[edge % n].off == 0.0) chains.push_back({{corners[edge % n]}});
        chains.back().corners.push_back(corners[(edge + 1) % n]);
    }
    return chains;
}

struct ChainEnd {
    double along = 0.0;  // position along the line [m]
    double lean = 0.0;  // cosine of the chain's direction at this end; sorts ends at the same position
    std::size_t chain = 0;
    bool first = false;
};

std::vector<ChainEnd> sortedEnds(const std::vector<Chain>& chains, double tolerance) {
    std::vector<ChainEnd> ends;
    for (std::size_t c = 0; c < chains.size(); ++c) {
        const std::vector<ChainCorner>& k = chains[c].corners;
        const auto lean = [](const ChainCorner& from, const ChainCorner& to) {
            return (to.along - from.along) / std::hypot(to.along - from.along, to.off);
        };
        ends.push_back({k.front().along, lean(k.front(), k[1]), c, true});
        ends.push_back({k.back().along, lean(k.back(), k[k.size() - 2]), c, false});
    }
    std::sort(ends.begin(), ends.end(), [](const ChainEnd& a, const ChainEnd& b) { return a.along < b.along; });
    for (std::size_t i = 0; i < ends.size();) {  // ends at the same position are sorted by direction
        std::size_t j = i + 1;
        while (j < ends.size() && ends[j].along - ends[j - 1].along <= tolerance) ++j;
        std::stable_sort(ends.begin() + static_cast<std::ptrdiff_t>(i), ends.begin() + static_cast<std::ptrdiff_t>(j),
                         [](const ChainEnd& a, const ChainEnd& b) { return a.lean < b.lean; });
        i = j;
    }
    return ends;
}

/// Joins the chains into closed pieces; empty if the ends do not pair.
std::vector<std::vector<Point>> closed(const std::vector<Chain>& chains, double tolerance) {
    const std::vector<ChainEnd> ends = sortedEnds(chains, tolerance);
    std::vector<std::size_t> next(chains.size(), chains.size());
    for (std::size_t i = 0; i + 1 < ends.size(); i += 2) {
        if (ends[i].first == ends[i + 1].first) return {};
        const ChainEnd& from = ends[i].first ? ends[i + 1] : ends[i];
        const ChainEnd& to = ends[i].first ? ends[i] : ends[i + 1];
        next[from.chain] = to.chain;
    }
    std::vector<char> used(chains.size(), 0);
    std::vector<std::vector<Point>> pieces;
    for (std::size_t c = 0; c < chains.size(); ++c) {
        if (used[c]) continue;
        std::vector<Point> piece;
        for (std::size_t at = c; !used[at]; at = next[at]) {
            used[at] = 1;
            for (const ChainCorner& k : chains[at].corners)
                if (piece.empty() || (k.p - piece.back()).norm() > tolerance) piece.push_back(k.p);
        }
        if (piece.size() > 1 && (piece.front() - piece.back()).norm() <= tolerance) piece.pop_back();
        if (piece.size() >= 3) pieces.push_back(std::move(piece));
    }
    return pieces;
}

std::vector<std::vector<Point>> piecesAbove(std::span<const Point> polygon, const std::vector<ChainCorner>& corners,
                                            double tolerance) {
    bool whole = false;
    const std::vector<Chain> chains = chainsAbove(corners, whole);
    if (whole) return {{polygon.begin(), polygon.end()}};
    return closed(chains, tolerance);
}

}  // namespace

Split split(std::span<const Point> polygon, const Point& place, const Point& along, double tolerance) {
    std::vector<ChainCorner> corners = cornersAndCrossings(polygon, place, along, tolerance);
    Split parts;
    parts.left = piecesAbove(polygon, corners, tolerance);
    for (ChainCorner& c : corners) c.along = -c.along, c.off = -c.off;
    parts.right = piecesAbove(polygon, corners, tolerance);
    return parts;
}

}  // namespace keyblock
