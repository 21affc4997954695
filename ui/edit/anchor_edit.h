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

/// One flag per node, in the order of `nodes`: true if an entry of the anchor table makes the node a bonded node.
/// \param nodes distances of the nodes from the far end [m], in increasing order.
std::vector<bool> realNodes(const std::vector<Anchor>& anchors, const std::vector<double>& nodes);

/// The anchor table after the nodes with the indices `first` to `last` have been made bonded (if `real` is true) or
/// intermediate (if it is false). New bonded nodes get the properties of the table entry that is nearest to node
/// `first`, or those of `pattern` if the table is empty. A bonded range extends half an element beyond its outermost
/// nodes.
/// \pre `nodes` has at least two entries, and first ≤ last < nodes.size().
std::vector<Anchor> withNodes(std::vector<Anchor> anchors, const std::vector<double>& nodes, std::size_t first,
                              std::size_t last, bool real, const Anchor& pattern);

/// Distances [m] of the nodes of a bolt from its far end, in increasing order. The bolt is divided into `divisions`
/// elements of equal length, or into 60 if `divisions` is null.
std::vector<double> evenNodes(double length, std::optional<int> divisions);

/// The bolt type with this name: that of the scene if there is one, otherwise the built-in type. Null if neither
/// exists.
const BoltType* boltTypeNamed(const Scene& scene, const std::string& name);

/// A node of a bolt that is not in the scene yet.
struct NodeAhead {
    double share = 0.0;  // distance from the far end over the length of the bolt
    bool real = false;  // bonded
};

/// The nodes that a bolt of this type, length [m] and number of divisions will have, in order from the far end to the
/// head. Empty if the type is unknown.
std::vector<NodeAhead> nodesAhead(const Scene& scene, const std::string& type, double length,
                                  std::optional<int> divisions);

}  // namespace keyblock
