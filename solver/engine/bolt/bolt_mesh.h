// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where a bolt's nodes are (theory, "Divisions"): given divisions as they are, or
// elements as short as what happens at a place asks for and long elsewhere.
#pragma once

#include <vector>

namespace keyblock {

/// A place near which elements are short.
struct FinePlace {
    double s = 0.0;  // from the far end [m]
    double element = 0.0;  // longest there [m]
    double zone = 0.0;  // to either side, over which that holds [m]
};

/// What an automatic mesh goes by; lengths from the far end [m].
struct MeshRequest {
    double length = 0.0;
    double longest = 0.0;  // of all elements
    std::vector<double> joints;  // rising; each in the middle of an element
    std::vector<double> nodes;  // where a node has to be, unless the element of a joint holds the place
    std::vector<FinePlace> fine;
};

/// Most elements of an automatic mesh; where more were wanted, all are longer in proportion.
inline constexpr int mostElements = 4000;

/// Equal elements.
std::vector<double> equalNodes(double length, int divisions);

/// Nodes from 0 to the length. Beyond the zones an element grows by a fifth of its distance from them. A mirrored request
/// gives the mirrored nodes, but for round-off.
std::vector<double> gradedNodes(const MeshRequest& request);

}  // namespace keyblock
