// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cuts a section into blocks: closed domains, parted by the traces of joints and
// by the outlines of tunnels. Which faces are adjacent is decided in exact
// arithmetic; before it near-misses are closed, and after it slivers are merged,
// and all changes are reported.
//
// The blocks depend on what was given alone: not on its order, nor on the way a
// trace or an outline runs, nor on traces given twice.
#pragma once

#include "geometry/point.h"

#include <optional>
#include <span>
#include <vector>

namespace keyblock {

/// The source of an edge that comes from the outline of a domain.
inline constexpr int borderSource = -1;

/// A region that is cut. Outlines of several domains may touch but not overlap.
/// \pre the outline does not cross itself; either direction.
struct CutDomain {
    int id = 0;
    std::vector<Point> outline;  // [m]
};

/// A straight trace of a joint, or one edge of a closed outline such as a tunnel's.
struct CutTrace {
    Point from{0.0, 0.0}, to{0.0, 0.0};  // [m]
    int source = 0;  // 0 or more; several traces may have the same. Where traces coincide, the lower one wins.
};

/// Limits. An empty one takes a default relative to the scene: the longer side of the box of all domains, or the faces.
struct CutSettings {
    std::optional<double> tolerance;  // what is closer than this meets [m]; 1e-6 of the size
    std::optional<double> minArea;  // smaller faces join a neighbour [m²]; 1e-3 of the mean face; 0 merges none
    std::optional<double> minWidth;  // narrower faces do [m]; the larger of 1e-2 of the mean face's side and
                                    // 10 tolerances; 0: none
    bool keepStraight = false;  // keep vertices where edges go straight on: neighbours then share whole edges
};

/// A closed line of vertices, none twice, the first not repeated; starting with the lowest vertex.
struct CutRing {
    std::vector<int> vertices;  // indices into Cut::vertices
    std::vector<int> sources;  // of the edge from vertex i to the next
};

/// Vertices at which an edge goes straight on with the same source are left out, so where a neighbour's edge ends on
/// the edge of a block that block has no vertex (but see CutSettings::keepStraight). Corners that blocks share are the
/// same vertex.
struct CutBlock {
    int domain = 0;  // id
    CutRing outer;  // counter-clockwise
    std::vector<CutRing> holes;  // clockwise; a hole may touch another ring in a vertex
    double area = 0.0;  // without the holes [m²]
    double width = 0.0;  // 2·area / perimeter with that of the holes: of a long strip its width, half of a square's [m]
};

enum class CutNoteKind {
    MergedTrace,  // a stretch lies on `other`, which has it; measure: its length [m]
    MovedEnd,  // an end went to the vertex it was close to; measure: how far [m]
    PulledEnd,  // an end was extended to a trace or border that it nearly reached; measure: how far it was away [m]
    TrimmedEnd,  // a loose end bounds no block; measure: its length [m]
    TrimmedStretch,  // as a loose end, but between places where the trace does bound blocks
    DroppedShort,  // a trace no longer than the tolerance; measure: its length [m]
    DroppedOutside,  // a trace without a part inside a domain; measure: its length [m]
    DroppedLoose,  // a trace that bounds no block; measure: its length inside [m]
    DroppedNotFinite,  // a trace or a domain with a coordinate that is not a number below 1e100; measure 0
    DroppedDomain,  // a domain without an area; source: its id; measure 0
    MergedSliver,  // a face under a limit joined a neighbour; source: of the longest edge between; measure: area [m²]
    MergedUnsound,  // the same for a face that would cross itself once its corners are rounded
    KeptSliver,  // a face under a limit without a neighbour in its domain; source: border; measure: area [m²]
};

/// Something that was changed or left out.
struct CutNote {
    CutNoteKind kind = CutNoteKind::MergedTrace;
    Point place{0.0, 0.0};  // [m]
    int source = borderSource;
    int other = borderSource;  // the source it met, or was merged with
    double measure = 0.0;
};

struct Cut {
    std::vector<Point> vertices;  // rising in x, then y; no two alike [m]
    std::vector<CutBlock> blocks;  // by domain id, then by the places of the outer ring's corners
    std::vector<CutNote> notes;  // by kind, place, source, other, measure
    double tolerance = 0.0, minArea = 0.0, minWidth = 0.0;  // that were used [m, m², m]
};

/// Cuts domains by traces. The tolerance that is used is at least 64 units in the last place of the coordinates and at
/// most a hundredth of the size. Traces are cut off at the border without a note. An outline that crosses itself
/// counts as inside where it winds round an odd number of times; where domains overlap, the lower id has the part.
/// Blocks tile their domains but for the rounding of corners, about 1e-15 of the size each, or the last place of the
/// coordinates where that is coarser.
/// \pre sources are 0 or more. Coordinates that are not finite are noted and left out.
Cut cutIntoBlocks(std::span<const CutDomain> domains, std::span<const CutTrace> traces, const CutSettings& settings);

}  // namespace keyblock
