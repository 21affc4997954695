// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Anchored points chosen by hand: entries of an anchor table that make some nodes
// of a bolt real and others artificial. A table has no entry that says "not here",
// so ranges are split round the nodes that let go.
#pragma once

#include "solver/scene/scene.h"

#include <optional>
#include <string>
#include <vector>

namespace keyblock {

/// True for each node that an entry makes real, as the program places entries.
/// \param nodes distances from the far end, rising [m].
std::vector<bool> realNodes(const std::vector<Anchor>& anchors, const std::vector<double>& nodes);

/// The table after the nodes `first` … `last` became real or artificial. New ones hold as the nearest that hold
/// already, else as `pattern` says. A real stretch reaches half an element beyond its last nodes.
/// \pre nodes has two or more entries and first ≤ last are among them.
std::vector<Anchor> withNodes(std::vector<Anchor> anchors, const std::vector<double>& nodes, std::size_t first,
                              std::size_t last, bool real, const Anchor& pattern);

/// Nodes of a bolt that says its divisions; of one that leaves them to the program, sixty equal ones. [m]
std::vector<double> evenNodes(double length, std::optional<int> divisions);

/// The type of that name: the scene's own, else the built-in one; null where there is none.
const BoltType* boltTypeNamed(const Scene& scene, const std::string& name);

/// A node of a bolt that is not there yet.
struct NodeAhead {
    double share = 0.0;  // of the length, from the far end
    bool real = false;
};

/// Nodes of a bolt of that type and length [m]; none of an unknown type.
std::vector<NodeAhead> nodesAhead(const Scene& scene, const std::string& type, double length,
                                  std::optional<int> divisions);

}  // namespace keyblock
