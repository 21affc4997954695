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

/// Whose an edge is. Where segments overlap, the lower `owner` has it and domains that come twice cancel.
struct EdgeMark {
    int owner = 0;
    std::array<int, 2> domains{-1, -1};  // that begin or end here, rising; −1 for none. A third is left out.
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
