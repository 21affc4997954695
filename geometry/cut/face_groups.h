// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Groups the faces of a planar map into blocks. Every face belongs to a domain, and a
// face that is too small is merged with the neighbour with the longest common edge.
// Edges with the same block on both sides bound nothing; this also removes loose ends.
#pragma once

#include "geometry/cut/planar_map.h"

#include <optional>
#include <vector>

namespace keyblock {

class FaceGroups {
public:
    /// Starts with one group per face. The map must outlive this object.
    explicit FaceGroups(const PlanarMap& map);

    /// Number of the group that contains a face: the lowest index of the faces in the group.
    int groupOf(int face) const;
    /// Index of the domain that contains a face (the lowest index if domains overlap); −1 if the face is outside all
    /// domains.
    int domainOf(int face) const { return domain_[face]; }
    double area(int group) const { return area_[static_cast<std::size_t>(group)]; }  // [m²]
    double width(int group) const;  // 2·area / perimeter [m]

    /// True if the groups on the two sides of a half-edge differ.
    bool bounds(int halfEdge) const { return groupAt(halfEdge) != groupAt(halfEdge ^ 1); }
    int groupAt(int halfEdge) const { return groupOf(map_.halfEdges[halfEdge].face); }

    /// Calls `visit(h)` for every half-edge `h` of the faces of a group.
    template <class Visit>
    void forEachHalfEdge(int group, Visit visit) const {
        int face = group;
        do {
            const std::size_t f = face;
            for (int k = start_[f]; k < start_[f + 1]; ++k) visit(ofFaces_[k]);
            face = nextFace_[f];
        } while (face != group);
    }

    /// An adjacent group in the same domain.
    struct Neighbour {
        int group = -1;
        double length = 0.0;  // total length of the common edges [m]
        int edge = -1;  // longest common edge
    };
    std::vector<Neighbour> neighbours(int group) const;

    /// The neighbour with the greatest total length of common edges; none if the group has no neighbours. If several
    /// are equal, the one with the largest area is returned; if the areas are equal too, the one with the lowest
    /// number.
    std::optional<Neighbour> longestNeighbour(int group) const;

    /// Merges a group with its neighbour. \return the number of the merged group
    int join(int group, const Neighbour& neighbour);

private:
    void findDomains();
    void listHalfEdges();
    void measure();
    const Point& startOf(int half) const {
        const HalfEdge& twin = map_.halfEdges[half ^ 1];
        return map_.points[twin.target];
    }

    const PlanarMap& map_;
    mutable std::vector<int> parent_;
    std::vector<int> nextFace_;  // next face of the same group, in a cycle
    std::vector<int> domain_;
    std::vector<int> ofFaces_, start_;  // half-edges of face f: ofFaces_[start_[f]] to ofFaces_[start_[f + 1] − 1]
    std::vector<double> area_, perimeter_;
};

/// A group whose area or width was below the limit.
struct Sliver {
    int edge = -1;  // longest edge that was removed; −1: no neighbour, not merged
    int halfEdge = -1;  // a half-edge of the group
    double area = 0.0;  // [m²]
};

/// Merges undersized groups, i.e. those with an area below `minArea` or a width below `minWidth`, with a neighbour. The
/// smallest group is merged first, and merging ends when no undersized group has a neighbour.
/// \param faces number of faces of the map
/// \param minArea [m²]
/// \param minWidth [m]
/// \return the undersized groups, including those that have no neighbour and were not merged
std::vector<Sliver> joinSlivers(FaceGroups& groups, int faces, double minArea, double minWidth);

}  // namespace keyblock
