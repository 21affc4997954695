// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Values that the verification reads from a run. A value that the run does not have
// is NaN, which fails every check.
#pragma once

#include "solver/results/results.h"
#include "solver/scene/scene.h"

#include <string>
#include <utility>
#include <vector>

namespace keyblock {

/// A scene with the results of its run.
struct Solved {
    Scene scene;
    Results results;
};

/// Runs a scene in memory.
Solved solve(Scene scene);

/// Value of a quantity in SI units. \param quantity the quantity in the notation of a scene's `quantities`.
double reading(const Solved& solved, const std::string& quantity);

/// Values of one monitor, one per history row. \param component for point monitors: 0 for ux, 1 for uy.
std::vector<double> series(const Solved& solved, const std::string& monitor, int component = 0);

/// Final displacement [m] of the monitor `slider` down a slope that dips at `slope` [°] towards +x.
double slidDown(const Solved& solved, double slope);

/// Load–opening curve of a pulled bolt: one point (opening [m], joint force [N]) per history row.
std::vector<std::pair<double, double>> loadPath(const Solved& solved);

/// Load [N] at an opening [m], interpolated linearly between the points of a load–opening curve; see `loadPath`.
double loadAtOpening(const std::vector<std::pair<double, double>>& path, double opening);

/// A debonding, rupture or plate loss, with the opening and the joint force just before it.
struct Release {
    EventKind kind = EventKind::Debonding;
    int index = -1;  // node, or for a rupture the element
    double opening = 0.0;  // [m]
    double load = 0.0;  // [N]
};

/// All debondings, ruptures and plate losses, in chronological order.
std::vector<Release> releases(const Solved& solved);

/// Number of releases before the first one that does not match `nodes`. Release i matches if it occurs at the node
/// `nodes[i]`.
int agreeing(const std::vector<Release>& found, const std::vector<int>& nodes);

/// Number of events of this kind in the run.
int countOf(const Solved& solved, EventKind kind);

}  // namespace keyblock
