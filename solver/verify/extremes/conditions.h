// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The conditions under which a scene with a known answer is run: everything that an
// axis can push. All scenes start from ordinary conditions.
#pragma once

#include "solver/scene/scene.h"

namespace keyblock {

struct Conditions {
    // section
    double size = 1.0;  // [m] of the block
    double ratio = 1.0;  // the number, or the size ratio, that the scene pushes
    double offset = 0.0;  // [m] by which the scene is moved along x and y
    double turn = 0.0;  // [°] by which the scene is turned, with its gravity
    bool mirrored = false;  // at the vertical axis, before it is turned
    // rock
    double density = 2700.0;  // [kg/m³]
    double modulus = 10e9;  // [Pa] Young's modulus of the block
    double contrast = 1.0;  // Young's modulus of what supports the block over that of the block
    double poisson = 0.2;
    double friction = 30.0;  // [°]
    double cohesion = 0.0;  // [Pa]
    // loads and motion
    double gravity = 9.81;  // [m/s²]
    double slope = 0.0;  // [°]
    double load = 1.0;  // in the unit of the scene
    double speed = 1.0;  // [m/s] or [rad/s]
    // bolts
    double bond = 2.5e8;  // [N/m per m]
    double divisions = 41.0;
    double barModulus = 200e9;  // [Pa]
    // numerical settings
    double timeStep = 1e-3;  // [s]
    double steps = 200.0;
    double penalty = 40.0;
    double shearRatio = 0.4;
    double tolerance = 1e-4;
    double iterations = 40.0;  // `max_passes`
    double thickness = 1.0;  // [m]
    double damping = 0.0;  // [1/s]
    Integration integration = Integration::Shi;
    ContactMethod contact = ContactMethod::Penalty;
    Iteration iteration = Iteration::Convex;
    Plane plane = Plane::Stress;
};

/// Moves, turns and mirrors a scene that was built in its own axes.
Scene placed(const Conditions& conditions, Scene scene);

/// A vector of the placed scene in the scene's own axes.
Point inOwnAxes(const Conditions& conditions, const Point& vector);

}  // namespace keyblock
