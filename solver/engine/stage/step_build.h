// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Turns model and state into the links and matrices of one step, and takes the
// accepted step back into the state.
#pragma once

#include "solver/engine/model/loads.h"
#include "solver/engine/step/step_problem.h"
#include "solver/engine/time/time_scheme.h"

namespace keyblock {

/// Everything of one step from where `state` is; its contacts were found for it.
StepProblem buildStep(const Model& model, const State& state, const Loads& loads, const LoadPoint& at,
                      const StepOptions& options);

/// Links of the contacts, in the order of the state's contacts: normal, then friction. Their directions and lever arms
/// are those where the blocks will be `ahead` [s] at the speed they have; half way, where their path is known.
void addContactLinks(const Model& model, const State& state, bool frictionLocked, StepProblem& problem,
                     double ahead = 0.0, const Eigen::VectorXd* path = nullptr);

/// Links of the points held by supports.
void addHeldPoints(const Model& model, const State& state, StepProblem& problem);

/// Links of one bolt: shank, anchored points, plate.
void addBoltLinks(const Model& model, const State& state, int bolt, StepProblem& problem);

/// Damping of a dynamic step into its matrices, loads and links; every link is there already.
void addDamping(const Model& model, const State& state, const StepOptions& options, StepProblem& problem);

/// Work of the damping of bodies over the step `d` [J]; that of shanks is a law's.
double dampedWork(const Model& model, const State& state, const StepOptions& options, const Eigen::VectorXd& d);

/// Where a slot is now.
struct SlotLine {
    Point p2{0.0, 0.0}, along{1.0, 0.0}, across{0.0, 1.0};
    double length = 0.0;  // [m]
};
SlotLine slotLine(const State& state, const Slot& slot);

/// Distance of a node from the slot's line, to its left [m].
double offSlot(const SlotLine& line, const BoltNode& node);

/// Node minus rock along the slot since bonding [m].
double alongSlot(const SlotLine& line, const BoltNode& node);

/// The curves of steel and anchor that hold in the stage: the dynamic ones where there are such; null without a curve.
const Backbone* steelNow(const BoltModel& bolt, const BoltMotion& motion);
const Backbone* curveNow(const AnchorModel& anchor, const BoltMotion& motion);

/// Friction that an anchored point can carry under the normal force it had, for one metre or one node [N/m or N].
double slidingLimit(const AnchorModel& anchor, const BoltNode& node, double strengthFactor);

/// How an element is strained where its nodes are now (theory, "The shank").
BeamStrains strainsOf(const BoltModel& bolt, const BoltMotion& motion, int element);

/// Stiffness of the spring that resists an element's p1, and its limit (and p2's) without axial force [N m]; a limit of
/// 0 where it has none.
double bendStiffness(const BoltModel& bolt, int element);
double hingeForce(const BoltModel& bolt, const BoltMotion& motion);

/// That limit under the axial force that the element carried when it was last accepted [N m].
double hingeLimit(const BoltModel& bolt, const BoltMotion& motion, int element);

/// Displacement of a motion's block along its axis since the start of the run [m].
double displacementAlong(const Model& model, const State& state, const PrescribedMotion& motion);

/// Moves blocks and nodes by the step's displacement; laws and forces stay as they are.
void moveBodies(const Model& model, State& state, const Eigen::VectorXd& d);

/// Accepts the step: takes forces and new history from the links at `d`, moves the bodies, and
/// books what friction and plastic flow used. Velocities are left to the caller.
void acceptStep(const Model& model, State& state, const StepProblem& problem, const Eigen::VectorXd& d);

/// Elastic energy held by the links and blocks where they are [J], by kind.
struct StoredEnergy {
    double strain = 0.0, contact = 0.0, bolt = 0.0;
};
StoredEnergy storedEnergy(const Model& model, const State& state);

/// Elastic energy held by one bolt: shank, anchored points and plate [J].
double boltEnergy(const Model& model, const State& state, int bolt);

/// Kinetic energy of blocks and bolts [J].
double kineticEnergy(const Model& model, const State& state);

/// All energies with their balance.
Energy energyOf(const Model& model, const State& state);

/// Everything stored, moving and used, less the work of the loads [J]: constant where the books balance.
double bookedEnergy(const Model& model, const State& state);

}  // namespace keyblock
