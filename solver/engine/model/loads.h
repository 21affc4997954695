// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// External loads on the blocks. The list of loads is fixed for a stage. A load point
// gives the factor of each load at one moment, and two load points define the load path
// of an increment.
#pragma once

#include "solver/engine/model/step_move.h"

#include <vector>

namespace keyblock {

/// Force of constant direction that moves with a point of a block.
struct PointForce {
    int block = -1;
    Point place{0.0, 0.0};  // position relative to the centroid, in the block's initial frame [m]
    Point force{0.0, 0.0};  // force over the full thickness [N]
};

/// Pressure on part of an edge. It remains normal to the edge as the block rotates.
struct EdgePressure {
    int block = -1, edge = -1;
    double from = 0.0, to = 1.0;  // start and end of the loaded part, as fractions of the edge
    double pressure = 0.0;  // positive if it compresses the block [Pa]
};

/// Prescribed displacement of a block's centroid along an axis.
struct PrescribedMotion {
    int block = -1;
    Point axis{1.0, 0.0};  // unit vector
    bool holdsRotation = true;  // rotation is fixed
};

/// Force that excavated rock, or a released support, exerted on a remaining block or bolt node.
struct WallForce {
    int block = -1;  // −1: acts on a bolt node
    int bolt = -1, node = -1;
    Point place{0.0, 0.0};  // position relative to the centroid, in the block's initial frame [m]
    Point force{0.0, 0.0};  // force over the full thickness [N]
    bool ofSupport = false;  // exerted by a released support
};

/// Dashpot that resists the motion of a point of a block.
struct Dashpot {
    int block = -1;
    Point place{0.0, 0.0};  // position relative to the centroid, in the block's initial frame [m]
    Point across{1.0, 0.0};  // unit normal of the side
    double pressure = 0.0, shear = 0.0;  // coefficients normal to and along the side [N s/m]
};

struct Loads {
    std::vector<PointForce> forces;
    std::vector<EdgePressure> pressures;
    std::vector<PrescribedMotion> motions;
    std::vector<WallForce> walls;
    std::vector<Dashpot> dashpots;  // in dynamic steps only
};

/// Magnitudes of all loads at one time: factors of the loads, and prescribed displacements and joint openings since the
/// start of the run.
struct LoadPoint {
    double time = 0.0;
    double gravity = 0.0;  // factor
    Point acceleration{0.0, 0.0};  // force per unit mass in addition to gravity [m/s²]
    std::vector<double> forces, pressures, motions, walls;  // factors per row of Loads; `motions`: displacements [m]
    std::vector<double> openings;  // joint openings since the start of the run, as State::openings; empty: none [m]
};

/// Linear interpolation between two load points.
/// \param share the position between them: 0 at `a`, 1 at `b`.
LoadPoint between(const LoadPoint& a, const LoadPoint& b, double share);

/// Largest change of a prescribed displacement or joint opening between two load points [m].
double longestDrive(const LoadPoint& a, const LoadPoint& b);

/// True if the loads at both points are equal, regardless of their times.
bool isSameLoad(const LoadPoint& a, const LoadPoint& b);

/// A single force due to a load other than self-weight.
struct SingleLoad {
    ForceSource source = ForceSource::Load;  // load, wall or support
    int block = -1;  // −1: acts on a bolt node
    int node = -1;  // index among all bolt nodes
    Point arm{0.0, 0.0};  // point of action relative to the block's centroid [m]
    Point force{0.0, 0.0};  // [N]
    Vector6 onUnknowns = Vector6::Zero();  // generalised force on the block's unknowns
};

/// Point forces, then pressures, then wall forces, each as a single force and in the order of `loads`.
/// \param move the expected displacement of the blocks over the step, which determines directions and lever arms.
std::vector<SingleLoad> singleLoads(const Model& model, const State& state, const Loads& loads, const LoadPoint& at,
                                    const StepMove& move);

/// Force per unit mass due to gravity and body acceleration [m/s²].
Point accelerationOf(const Model& model, const LoadPoint& at);

/// Weight per unit mass used as the reference for unbalanced forces [m/s²]: the largest of full gravity, body
/// acceleration and their vector sum.
double weightPerMass(const Model& model, const LoadPoint& at);

/// Generalised force on every unknown due to gravity, body acceleration, point forces, pressures and wall forces.
/// \param move as in `singleLoads`. \param total receives the sum of the magnitudes of these forces [N].
Eigen::VectorXd externalForce(const Model& model, const State& state, const Loads& loads, const LoadPoint& at,
                              const StepMove& move, double& total);

}  // namespace keyblock
