// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cuts a section into blocks: closed domains are divided by joint traces and tunnel
// outlines. The topology is computed in exact arithmetic. Before that, small gaps
// between traces are closed; afterwards, slivers are merged. All changes are reported.
//
// The blocks do not depend on the order of the input, on the direction of traces and
// outlines, or on repeated traces.
#pragma once

#include "geometry/point.h"

#include <optional>
#include <span>
#include <vector>

namespace keyblock {

/// Source number of edges on the outline of a domain.
inline constexpr int borderSource = -1;

/// A region to be cut. The outlines of several domains may touch but should not overlap.
/// \pre the outline does not cross itself; it may run clockwise or counter-clockwise.
struct CutDomain {
    int id = 0;
    std::vector<Point> outline;  // [m]
};

/// A straight trace of a joint, or one edge of a closed outline, for example of a tunnel.
struct CutTrace {
    Point from{0.0, 0.0}, to{0.0, 0.0};  // [m]
    int source = 0;  // 0 or more, shared by any number of traces; where traces coincide, the lower applies
};

/// Limits of the cut. The defaults are relative to the size (longer side of the bounding box of all domains) or to the
/// mean area of the faces.
struct CutSettings {
    std::optional<double> tolerance;  // [m]; points and lines closer than this are joined; default: 1e-6 of the size
    std::optional<double> minArea;  // [m²]; smaller faces are merged; default: 1e-3 of the mean area; 0: none
    std::optional<double> minWidth;  // [m]; narrower faces are merged; default: 1e-2 of the square root of the
                                    // mean area, at least 10 tolerances; 0: none
    bool keepStraight = false;  // keeps vertices on straight edges, so that neighbours share whole edges
};

/// A closed ring of distinct vertices, starting with the vertex of lowest index, which is not repeated at the end.
struct CutRing {
    std::vector<int> vertices;  // indices into Cut::vertices
    std::vector<int> sources;  // source of the edge from vertex i to the next
};

/// A block. Unless CutSettings::keepStraight is set, a vertex between two collinear edges of the same source is
/// omitted; a block then has no vertex at a point where a neighbour's edge ends on one of the block's edges. A corner
/// shared by several blocks is the same vertex in all of them.
struct CutBlock {
    int domain = 0;  // id of the domain
    CutRing outer;  // counter-clockwise
    std::vector<CutRing> holes;  // clockwise; a hole may touch another ring at a vertex
    double area = 0.0;  // without the holes [m²]
    double width = 0.0;  // 2·area / perimeter, holes included [m]; of a long strip its width, of a square half its side
};

enum class CutNoteKind {
    MergedTrace,  // part of the trace coincides with `other` and was merged with it; measure: its length [m]
    MovedEnd,  // an end was moved to a nearby vertex; measure: the distance [m]
    PulledEnd,  // an end was extended to a trace or boundary that it nearly reached; measure: the gap [m]
    TrimmedEnd,  // an end part bounds no block and was removed; measure: its length [m]
    TrimmedStretch,  // an intermediate part bounds no block and was removed; measure: its length [m]
    DroppedShort,  // the trace is too short for the tolerance; measure: its length [m]
    DroppedOutside,  // no part of the trace lies inside a domain; measure: its length [m]
    DroppedLoose,  // the trace bounds no block; measure: its length inside the domains [m]
    DroppedNotFinite,  // a coordinate of the trace or domain is not a number below 1e100; measure: 0
    DroppedDomain,  // the domain has no area; source: its id; measure: 0
    MergedSliver,  // a face below a limit was merged; source: of the longest edge removed; measure: its area [m²]
    MergedUnsound,  // as MergedSliver, for a face that would cross itself because of the round-off of its corners
    KeptSliver,  // a face below a limit has no neighbour in its domain; source: border; measure: its area [m²]
};

/// A change or omission made by the cut.
struct CutNote {
    CutNoteKind kind = CutNoteKind::MergedTrace;
    Point place{0.0, 0.0};  // [m]
    int source = borderSource;
    int other = borderSource;  // source of the trace or boundary that it was extended to or merged with
    double measure = 0.0;
};

struct Cut {
    std::vector<Point> vertices;  // distinct, in increasing order of x, then y [m]
    std::vector<CutBlock> blocks;  // sorted by domain id, then by the corners of the outer ring
    std::vector<CutNote> notes;  // sorted by kind, place, source, other, measure
    double tolerance = 0.0, minArea = 0.0, minWidth = 0.0;  // limits that were used [m], [m²], [m]
};

/// Cuts domains by traces. The tolerance used is at least 64 units in the last place of the coordinates and at most a
/// hundredth of the size (see CutSettings). Traces are trimmed at the boundary without a note. Blocks tile their
/// domains except for the round-off of corner coordinates, which is about 1e-15 of the size, or one unit in the last
/// place of the coordinates if that is coarser. Invalid domains also give a defined result: the interior of an outline that crosses
/// itself is determined by the even-odd rule, and where domains overlap, the one with the lower id takes precedence.
/// Traces and domains with coordinates that are not finite are reported and omitted.
/// \pre source numbers are not negative.
Cut cutIntoBlocks(std::span<const CutDomain> domains, std::span<const CutTrace> traces, const CutSettings& settings);

}  // namespace keyblock
