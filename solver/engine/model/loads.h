// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What acts on the blocks from outside. The list is fixed for a stage; how much
// of each acts at a moment is a load point, and two load points span the path
// that an increment follows.
#pragma once

#include "solver/engine/model/step_move.h"

#include <vector>

namespace keyblock {

/// Keeps its direction and follows its point of the block.
struct PointForce {
    int block = -1;
    Point place{0.0, 0.0};  // in the block's frame at the start, from its centroid [m]
    Point force{0.0, 0.0};  // [N] over the whole thickness
};

/// Stays on its edge and normal to it as the block turns.
struct EdgePressure {
    int block = -1, edge = -1;
    double from = 0.0, to = 1.0;  // part of the edge
    double pressure = 0.0;  // [Pa] positive presses on the block
};

/// Prescribes the centroid's displacement along an axis.
struct PrescribedMotion {
    int block = -1;
    Point axis{1.0, 0.0};  // unit vector
    bool holdsRotation = true;
};

/// What excavated rock, or a released support, gave to a block or to a node of a bolt that stays.
struct WallForce {
    int block = -1;  // −1: on the node
    int bolt = -1, node = -1;
    Point place{0.0, 0.0};  // in the block's frame at the start, from its centroid [m]
    Point force{0.0, 0.0};  // [N] over the whole thickness
    bool ofSupport = false;  // of a support that was released
};

/// Acts against the velocity of its point of the block.
struct Dashpot {
    int block = -1;
    Point place{0.0, 0.0};  // in the block's frame at the start, from its centroid [m]
    Point across{1.0, 0.0};  // normal to the side
    double pressure = 0.0, shear = 0.0;  // across and along the side [N s/m]
};

struct Loads {
    std::vector<PointForce> forces;
    std::vector<EdgePressure> pressures;
    std::vector<PrescribedMotion> motions;
    std::vector<WallForce> walls;
    std::vector<Dashpot> dashpots;  // in motion only
};

/// How much acts at a moment: factors of the loads, displacements since the start of the run [m].
struct LoadPoint {
    double time = 0.0;
    double gravity = 0.0;  // factor
    Point acceleration{0.0, 0.0};  // force per mass beside gravity [m/s²]
    std::vector<double> forces, pressures, motions, walls;  // rows of Loads
    std::vector<double> openings;  // since the start of the run, as State::openings; empty: none [m]
};

/// \param share 0 at `a`, 1 at `b`.
LoadPoint between(const LoadPoint& a, const LoadPoint& b, double share);

/// The farthest that a prescribed motion or a joint that dilates goes between two load points [m].
double longestDrive(const LoadPoint& a, const LoadPoint& b);

/// True where the same acts at both, whenever that is.
bool isSameLoad(const LoadPoint& a, const LoadPoint& b);

/// A single force of the loads, but for weights.
struct SingleLoad {
    ForceSource source = ForceSource::Load;  // load, wall or support
    int block = -1;  // −1: on the node
    int node = -1;  // of all nodes
    Point arm{0.0, 0.0};  // from the block's centroid to where it acts [m]
    Point force{0.0, 0.0};  // [N]
    Vector6 onUnknowns = Vector6::Zero();  // of the block
};

/// Point forces, pressures and forces of walls. \param move of the blocks over the step, within which loads take their
/// directions and lever arms.
std::vector<SingleLoad> singleLoads(const Model& model, const State& state, const Loads& loads, const LoadPoint& at,
                                    const StepMove& move);

/// Force per mass of gravity and of accelerations that act like it [m/s²].
Point accelerationOf(const Model& model, const LoadPoint& at);

/// Weight per mass that what is unbalanced is compared with: the largest of gravity, body acceleration and both [m/s²].
double weightPerMass(const Model& model, const LoadPoint& at);

/// Generalised forces of gravity, forces, pressures and excavated walls on every unknown. \param move as for
/// `singleLoads`. \return summed magnitudes [N] in `total`.
Eigen::VectorXd externalForce(const Model& model, const State& state, const Loads& loads, const LoadPoint& at,
                              const StepMove& move, double& total);

}  // namespace keyblock
