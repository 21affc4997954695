// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Finds walls for the heads of bolts, with the direction into the rock: walls of
// tunnels first, else the outline of the rock and the faces of blocks.
#pragma once

#include "solver/scene/scene.h"

#include <optional>
#include <string>
#include <vector>

namespace keyblock {

struct WallPlace {
    Point place{0.0, 0.0};  // point on the wall as cut, whose arcs are polylines [m]
    Point inward{0.0, 1.0};  // unit vector into the rock, normal to the wall
    double along = 0.0;  // for a tunnel: length along its exact profile, counter-clockwise from its start [m]
    int tunnel = -1;  // index of the tunnel; −1: not the wall of a tunnel
    std::string name;  // shown to the user: `wall of tunnel drift`
};

/// The nearest wall within `radius` [m] of a point; null if there is none. Tunnel walls take precedence over other
/// faces.
std::optional<WallPlace> wallAt(const Scene& scene, const Point& place, double radius);

/// The point on the wall of a tunnel nearest to `place`, at any distance; null if the tunnel does not exist or its
/// shape is invalid.
std::optional<WallPlace> wallOfTunnel(const Scene& scene, int tunnel, const Point& place);

/// Length [m] of the part of a tunnel's wall from `from` to `to` in the given direction; the length of the whole wall
/// if the positions coincide. `from` and `to` are lengths along the wall [m], as in `WallPlace::along`.
double runAlong(const SceneTunnel& tunnel, double from, double to, Way way);

/// The part of a tunnel's wall from `from` to `to` in the given direction, as a polyline [m]; the whole wall if the
/// positions coincide. `from` and `to` are lengths along the wall [m], as in `WallPlace::along`.
std::vector<Point> wallBetween(const SceneTunnel& tunnel, double from, double to, Way way);

}  // namespace keyblock
