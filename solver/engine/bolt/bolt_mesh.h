// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Positions of a bolt's nodes (theory, "Divisions"): elements of equal length, or
// elements that are short at joints and in load-transfer zones and long elsewhere.
#pragma once

#include <vector>

namespace keyblock {

/// A position near which the mesh is refined.
struct FinePlace {
    double s = 0.0;  // distance from the far end [m]
    double element = 0.0;  // maximum element length there [m]
    double zone = 0.0;  // distance to either side over which that maximum applies [m]
};

/// Input of an automatic mesh; positions are distances from the far end [m].
struct MeshRequest {
    double length = 0.0;  // of the bolt [m]
    double longest = 0.0;  // maximum length of any element [m]
    std::vector<double> joints;  // in ascending order; each joint is placed in the middle of an element
    std::vector<double> nodes;  // required nodes in ascending order, ignored if inside a joint's element
    std::vector<FinePlace> fine;
};

/// Approximate maximum number of elements of an automatic mesh. If the requested element lengths would give more, all
/// elements are lengthened in proportion; there is still at least one element per joint.
inline constexpr int mostElements = 4000;

/// Node positions for `divisions` elements of equal length, from 0 to `length` [m].
std::vector<double> equalNodes(double length, int divisions);

/// Node positions of an automatic mesh, from 0 to the length of the bolt [m]. Outside the refined zones the maximum
/// element length increases by a fifth of the distance from them. Apart from round-off, a mirrored request gives
/// mirrored positions.
std::vector<double> gradedNodes(const MeshRequest& request);

}  // namespace keyblock
