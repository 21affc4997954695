// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Anchored points set by hand: entries of an anchor table that make some nodes of a
// bolt bonded and others intermediate. A table has no entry for "not here", so
// ranges are split around the nodes that are removed.
#pragma once

#include "solver/scene/scene.h"

#include <optional>
#include <string>
#include <vector>

namespace keyblock {

/// True for each node that an entry makes real.
/// \param nodes distances from the far end, increasing [m].
std::vector<bool> realNodes(const std::vector<Anchor>& anchors, const std::vector<double>& nodes);

/// The table after the nodes `first` … `last` became real or artificial. New ones have the law of the nearest real
/// node, else that of `pattern`. A real interval extends half an element beyond its last nodes.
/// \pre nodes has two or more entries and first ≤ last are among them.
std::vector<Anchor> withNodes(std::vector<Anchor> anchors, const std::vector<double>& nodes, std::size_t first,
                              std::size_t last, bool real, const Anchor& pattern);

/// Nodes of a bolt with given divisions; sixty equal divisions if they are automatic. [m]
std::vector<double> evenNodes(double length, std::optional<int> divisions);

/// The type with that name: the scene's own, else the built-in one; null if there is none.
const BoltType* boltTypeNamed(const Scene& scene, const std::string& name);

/// A node of a bolt that does not exist yet.
struct NodeAhead {
    double share = 0.0;  // of the length, from the far end
    bool real = false;
};

/// Nodes of a bolt of that type and length [m]; none if the type is unknown.
std::vector<NodeAhead> nodesAhead(const Scene& scene, const std::string& type, double length,
                                  std::optional<int> divisions);

}  // namespace keyblock
