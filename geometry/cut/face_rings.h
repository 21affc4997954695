// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The outlines of groups of faces: closed rings of vertices without loose ends,
// repeated vertices or redundant corners. Rounding of the corners may have turned a
// face inside out, so every outline is checked again in its final form.
#pragma once

#include "geometry/cut/cut.h"
#include "geometry/cut/face_groups.h"
#include "geometry/cut/planar_map.h"

#include <span>
#include <vector>

namespace keyblock {

/// Outlines of one block; their vertices are indices into PlanarMap::points.
struct TracedBlock {
    CutRing outer;
    std::vector<CutRing> holes;
    double area = 0.0;  // without the holes [m²]
    double perimeter = 0.0;  // including the holes [m]
};

/// Blocks of one group: usually one; none if round-off of the corner coordinates reduces the group to nothing; several
/// if it splits the group at a vertex.
struct TracedGroup {
    std::vector<TracedBlock> blocks;
    bool sound = false;  // edges of a block meet only at common vertices, and holes lie inside it
};

class RingTracer {
public:
    /// `map`, `groups` and `sources` must outlive the tracer.
    /// \param sources source of each edge owner (as in CutTrace::source), indexed by EdgeMark::owner
    /// \param straight [m] a vertex between edges of the same source is removed if it lies within this distance of the
    /// chord between its neighbours; negative: no vertices are removed
    /// \pre the points of the map are distinct and in increasing order of x, then y.
    RingTracer(const PlanarMap& map, const FaceGroups& groups, std::span<const int> sources, double straight);

    TracedGroup trace(int group);

private:
    struct Corner {
        int vertex = 0;
        int owner = 0;  // owner of the edge to the next corner
    };
    using Loop = std::vector<Corner>;

    void walk(int group);
    void split(int firstHalf, int group);
    void closeLoop(std::size_t first);
    bool isStraight(const Corner& before, const Corner& corner, const Corner& after) const;
    Loop withoutStraight(const Loop& loop) const;
    CutRing ringOf(const Loop& loop) const;
    TracedGroup blocksOf(const std::vector<Loop>& loops) const;
    bool isSound(const TracedBlock& block) const;
    const Point& at(int vertex) const { return map_.points[vertex]; }
    int source(int owner) const { return sources_[owner]; }

    const PlanarMap& map_;
    const FaceGroups& groups_;
    std::span<const int> sources_;
    double straight_;
    std::vector<int> walked_;  // per half-edge: number of the last walk that visited it
    int walks_ = 0;
    std::vector<int> place_;  // per vertex: position in the current line; −1: not in it
    std::vector<int> uses_;  // per vertex: number of times that the loops of the group use it
    Loop line_;
    std::vector<Loop> loops_;
};

}  // namespace keyblock
