// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Faces of a planar map put together into blocks: each knows its domain, and a
// face that is too small joins the neighbour with which it shares most edge. An
// edge with the same block on both sides bounds nothing; that is how loose ends
// vanish as well.
#pragma once

#include "geometry/planar_map.h"

#include <optional>
#include <vector>

namespace keyblock {

class FaceGroups {
public:
    /// Every face by itself. The map must outlive the groups.
    explicit FaceGroups(const PlanarMap& map);

    /// The group that a face is in: the lowest of its faces.
    int groupOf(int face) const;
    /// Index of the domain that a face lies in, the lowest where domains overlap; −1 outside.
    int domainOf(int face) const { return domain_[static_cast<std::size_t>(face)]; }
    double area(int group) const { return area_[static_cast<std::size_t>(group)]; }  // [m²]
    double width(int group) const;  // 2·area / perimeter [m]

    /// True when a half-edge has another group on its other side.
    bool bounds(int halfEdge) const { return groupAt(halfEdge) != groupAt(halfEdge ^ 1); }
    int groupAt(int halfEdge) const { return groupOf(map_.halfEdges[static_cast<std::size_t>(halfEdge)].face); }

    /// Calls `visit(h)` for the half-edges of all faces of a group.
    template <class Visit>
    void forEachHalfEdge(int group, Visit visit) const {
        int face = group;
        do {
            const auto f = static_cast<std::size_t>(face);
            for (int k = start_[f]; k < start_[f + 1]; ++k) visit(ofFaces_[static_cast<std::size_t>(k)]);
            face = nextFace_[f];
        } while (face != group);
    }

    /// An adjacent group of the same domain.
    struct Neighbour {
        int group = -1;
        double length = 0.0;  // of all edges between [m]
        int edge = -1;  // the longest of them
    };
    std::vector<Neighbour> neighbours(int group) const;

    /// The neighbour with the longest common edge; of several the larger, then the first. None without neighbours.
    std::optional<Neighbour> longestNeighbour(int group) const;

    /// Puts a group and its neighbour together. \return the new group.
    int join(int group, const Neighbour& neighbour);

private:
    void findDomains();
    void listHalfEdges();
    void measure();
    const Point& startOf(int half) const {
        const HalfEdge& twin = map_.halfEdges[static_cast<std::size_t>(half ^ 1)];
        return map_.points[static_cast<std::size_t>(twin.target)];
    }

    const PlanarMap& map_;
    mutable std::vector<int> parent_;
    std::vector<int> nextFace_;  // round the faces of a group
    std::vector<int> domain_;
    std::vector<int> ofFaces_, start_;  // half-edges face by face
    std::vector<double> area_, perimeter_;
};

/// A group that was under a limit.
struct Sliver {
    int edge = -1;  // the longest of those that vanished, −1 where there was no neighbour
    int halfEdge = -1;  // one of the group
    double area = 0.0;  // [m²]
};

/// Joins groups under a limit to neighbours, the smallest first, until none is left that has a neighbour.
std::vector<Sliver> joinSlivers(FaceGroups& groups, int faces, double minArea, double minWidth);

}  // namespace keyblock
