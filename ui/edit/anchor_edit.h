// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bonded nodes set by hand: functions that change an anchor table so that given nodes
// of a bolt become bonded or intermediate. A table has no entry for "not bonded here",
// so ranges are split around the nodes that are removed.
#pragma once

#include "solver/scene/scene.h"

#include <optional>
#include <string>
#include <vector>

namespace keyblock {

/// For each node, true if an entry of the anchor table makes it a bonded node.
/// \param nodes distances of the nodes from the far end [m], in increasing order.
std::vector<bool> realNodes(const std::vector<Anchor>& anchors, const std::vector<double>& nodes);

/// The anchor table after the nodes `first` to `last` have been made bonded (if `real` is true) or intermediate (if it
/// is false). New bonded nodes get the anchor law of the nearest bonded node or, if there is none, the law of
/// `pattern`. A bonded range extends half an element beyond its outermost nodes.
/// \pre `nodes` has at least two entries, and first ≤ last < nodes.size().
std::vector<Anchor> withNodes(std::vector<Anchor> anchors, const std::vector<double>& nodes, std::size_t first,
                              std::size_t last, bool real, const Anchor& pattern);

/// Distances [m] of the nodes of a bolt from its far end. The bolt has the given number of equal divisions, or 60 if
/// the number is automatic.
std::vector<double> evenNodes(double length, std::optional<int> divisions);

/// The bolt type with this name from the scene or, if the scene has none, from the built-in types; null if there is
/// none.
const BoltType* boltTypeNamed(const Scene& scene, const std::string& name);

/// A node of a bolt that is not in the scene yet.
struct NodeAhead {
    double share = 0.0;  // distance from the far end over the length of the bolt
    bool real = false;  // bonded
};

/// The nodes that a bolt of this type and length [m] will have; empty if the type is unknown.
std::vector<NodeAhead> nodesAhead(const Scene& scene, const std::string& type, double length,
                                  std::optional<int> divisions);

}  // namespace keyblock
