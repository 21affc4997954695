// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The outlines of groups of faces: closed lines of vertices without loose ends,
// pinches or needless corners. Corners are rounded by now, and rounding may turn
// a face inside out; so every outline is checked again in its final form.
#pragma once

#include "geometry/cut.h"
#include "geometry/face_groups.h"
#include "geometry/planar_map.h"

#include <span>
#include <vector>

namespace keyblock {

/// Outlines with indices of vertices of the map.
struct TracedBlock {
    CutRing outer;
    std::vector<CutRing> holes;
    double area = 0.0;  // without the holes [m²]
    double perimeter = 0.0;  // with that of the holes [m]
};

/// A group is one block; none where rounding leaves nothing of it, several where it parts it at a vertex.
struct TracedGroup {
    std::vector<TracedBlock> blocks;
    bool sound = false;  // edges of a block meet at most at common vertices, holes lie inside
};

class RingTracer {
public:
    /// `sources` of the owners that the map's marks name. Within `straight` [m] of the chord a vertex between edges of
    /// the same source goes; between edges of the same owner it always does; negative: all stay. All three must outlive
    /// the tracer.
    /// \pre the map's points rise in x, then y, and no two are alike.
    RingTracer(const PlanarMap& map, const FaceGroups& groups, std::span<const int> sources, double straight);

    TracedGroup trace(int group);

private:
    struct Corner {
        int vertex = 0;
        int owner = 0;  // of the edge that leaves
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
    const Point& at(int vertex) const { return map_.points[static_cast<std::size_t>(vertex)]; }
    int source(int owner) const { return sources_[static_cast<std::size_t>(owner)]; }

    const PlanarMap& map_;
    const FaceGroups& groups_;
    std::span<const int> sources_;
    double straight_;
    std::vector<int> walked_;  // the number of the walk that came over a half-edge
    int walks_ = 0;
    std::vector<int> place_;  // of a vertex in the line that is being walked, −1 elsewhere
    std::vector<int> uses_;  // by the loops of the group, of vertices
    Loop line_;
    std::vector<Loop> loops_;
};

}  // namespace keyblock
