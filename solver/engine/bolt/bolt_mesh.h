// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Positions of a bolt's nodes (theory, "Divisions"): equal elements, or elements that
// are short at joints and where load is transferred, and long elsewhere.
#pragma once

#include <vector>

namespace keyblock {

/// A position near which elements are short.
struct FinePlace {
    double s = 0.0;  // from the far end [m]
    double element = 0.0;  // longest there [m]
    double zone = 0.0;  // to either side, over which that holds [m]
};

/// Input of an automatic mesh; positions from the far end [m].
struct MeshRequest {
    double length = 0.0;
    double longest = 0.0;  // of all elements
    std::vector<double> joints;  // rising; each in the middle of an element
    std::vector<double> nodes;  // rising: positions of nodes, unless a joint's element covers them
    std::vector<FinePlace> fine;
};

/// About the most elements of an automatic mesh, at least one for each joint: where more were requested, all are longer
/// in proportion.
inline constexpr int mostElements = 4000;

/// Equal elements.
std::vector<double> equalNodes(double length, int divisions);

/// Nodes from 0 to the length. Beyond the zones an element grows by a fifth of its distance from them. A mirrored
/// request gives the mirrored nodes, but for round-off.
std::vector<double> gradedNodes(const MeshRequest& request);

}  // namespace keyblock
