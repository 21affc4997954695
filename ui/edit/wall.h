// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Walls for the heads of bolts: of tunnels first, else the outline of the rock and
// the faces of blocks, with the direction into the rock.
#pragma once

#include "solver/scene/scene.h"

#include <optional>
#include <string>
#include <vector>

namespace keyblock {

struct WallPlace {
    Point place{0.0, 0.0};  // on the wall as it is cut [m]
    Point inward{0.0, 1.0};  // unit vector into the rock, normal to the wall
    double along = 0.0;  // of a tunnel: length along its true wall, counter-clockwise from its start [m]
    int tunnel = -1;  // index; −1: another face
    std::string name;  // shown to the user: `wall of tunnel drift`
};

/// The wall nearest to `place` within `radius` [m], tunnels before others, if there is one.
std::optional<WallPlace> wallAt(const Scene& scene, const Point& place, double radius);

/// The same on one tunnel, at any distance. None if the tunnel cannot be drawn.
std::optional<WallPlace> wallOfTunnel(const Scene& scene, int tunnel, const Point& place);

/// Distance along a tunnel's wall from one point to another in a direction [m]; the whole wall if they coincide.
double runAlong(const SceneTunnel& tunnel, double from, double to, Way way);

/// The wall between two points as a line from `from` to `to` [m].
std::vector<Point> wallBetween(const SceneTunnel& tunnel, double from, double to, Way way);

}  // namespace keyblock
