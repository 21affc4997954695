// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The faces that straight segments cut the plane into, found in exact arithmetic
// and handed out as flat arrays of plain numbers: nothing that follows touches an
// exact number or walks a tree of nodes.
#pragma once

#include "geometry/point.h"

#include <array>
#include <span>
#include <vector>

namespace keyblock {

/// Up to two domains, by index, rising; −1 for none.
using Domains = std::array<int, 2>;

/// The domains in one of two sets but not in both; a third is left out.
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

/// Whose an edge is. Where segments overlap, the lower `owner` has it and domains that come twice cancel.
struct EdgeMark {
    int owner = 0;
    Domains domains{-1, -1};  // that begin or end here
};

struct MarkedSegment {
    Point from{0.0, 0.0}, to{0.0, 0.0};  // [m]
    EdgeMark mark;
};

/// A half-edge runs along its edge with its face on the left. Half-edges 2e and 2e + 1 are the two of edge e.
struct HalfEdge {
    int next = -1;  // half-edge of the same face
    int target = -1;  // vertex it runs to
    int face = -1;
};

struct PlanarMap {
    std::vector<Point> points;  // vertices, rounded; two may round to the same
    std::vector<HalfEdge> halfEdges;
    std::vector<EdgeMark> marks;  // of edges
    int faces = 0;  // face 0 is the unbounded one
};

/// The map of segments that may cross, touch and overlap in any way. Vertices are exact within `precision` [m], or the
/// nearest doubles where that is coarser. The same segments in the same order give the same map.
/// \pre finite coordinates, no segment without length.
PlanarMap planarMap(std::span<const MarkedSegment> segments, double precision);

}  // namespace keyblock
