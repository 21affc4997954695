// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the verification reads from a run. A number that the run did not leave
// is NaN, which meets no expectation.
#pragma once

#include "solver/results/results.h"
#include "solver/scene/scene.h"

#include <string>
#include <utility>
#include <vector>

namespace keyblock {

/// A run with the scene it came from.
struct Solved {
    Scene scene;
    Results results;
};

/// Runs a scene in memory.
Solved solve(Scene scene);

/// A text as in a scene's `quantities` [SI].
double reading(const Solved& solved, const std::string& quantity);

/// Values of one monitor over the history. \param component 1 for uy of a point.
std::vector<double> series(const Solved& solved, const std::string& monitor, int component = 0);

/// Distance that the monitor `slider` went down a slope of `slope` [°] that falls towards +x [m].
double slidDown(const Solved& solved, double slope);

/// (opening [m], joint force [N]) over the history of a pulled bolt.
std::vector<std::pair<double, double>> loadPath(const Solved& solved);

/// Load at an opening, linear between rows [N].
double loadAtOpening(const std::vector<std::pair<double, double>>& path, double opening);

/// An event that lets something go, with opening and joint force just before it.
struct Release {
    EventKind kind = EventKind::Debonding;
    int index = -1;  // node, or element of a rupture
    double opening = 0.0;  // [m]
    double load = 0.0;  // [N]
};

/// Debondings, ruptures and lost plates in their order.
std::vector<Release> releases(const Solved& solved);

/// Number of leading entries in which the nodes of the releases are those given.
int agreeing(const std::vector<Release>& found, const std::vector<int>& nodes);

/// Number of events of a kind.
int countOf(const Solved& solved, EventKind kind);

}  // namespace keyblock
