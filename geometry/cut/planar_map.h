// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The faces into which straight segments divide the plane. They are computed in exact
// arithmetic and returned as flat arrays of ordinary numbers, so that later code needs
// neither exact numbers nor linked nodes.
#pragma once

#include "geometry/point.h"

#include <array>
#include <span>
#include <vector>

namespace keyblock {

/// Indices of up to two domains, in increasing order; −1: none.
using Domains = std::array<int, 2>;

/// The domains that are in exactly one of the two sets; if there are more than two, the lowest two.
inline Domains inOneOf(const Domains& a, const Domains& b) {
    Domains found{-1, -1};
    for (std::size_t i = 0, j = 0, count = 0; count < 2;) {
        const int p = i < 2 ? a[i] : -1, q = j < 2 ? b[j] : -1;
        if (p < 0 && q < 0) break;
        if (p != q) found[count++] = q < 0 || (p >= 0 && p < q) ? p : q;
        const bool first = q < 0 || (p >= 0 && p <= q), second = p < 0 || (q >= 0 && q <= p);
        i += first;
        j += second;
    }
    return found;
}

/// The owner of an edge and the domains that the edge bounds. Where segments overlap, their common edge has the lowest
/// of their owners, and a domain that occurs twice cancels out.
struct EdgeMark {
    int owner = 0;
    Domains domains{-1, -1};  // domains with the edge on their outline
};

struct MarkedSegment {
    Point from{0.0, 0.0}, to{0.0, 0.0};  // [m]
    EdgeMark mark;
};

/// An edge traversed in one of its two directions, with a face on the left. Edge e consists of the half-edges 2e and
/// 2e + 1.
struct HalfEdge {
    int next = -1;  // next half-edge of the same face
    int target = -1;  // vertex at its end
    int face = -1;
};

struct PlanarMap {
    std::vector<Point> points;  // vertices, rounded; two may be rounded to the same point
    std::vector<HalfEdge> halfEdges;
    std::vector<EdgeMark> marks;  // one per edge
    int faces = 0;  // face 0 is the unbounded one
};

/// The planar map of segments, which may cross, touch and overlap in any way. The same segments in the same order
/// always give the same map.
/// \param precision [m] largest error of a vertex, unless the spacing of doubles is coarser
/// \pre coordinates are finite, and no segment has zero length.
PlanarMap planarMap(std::span<const MarkedSegment> segments, double precision);

}  // namespace keyblock
