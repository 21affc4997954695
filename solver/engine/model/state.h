// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// All data that change during a run, as plain values. A copy serves as the checkpoint
// before a step, and assigning it back undoes the step.
#pragma once

#include "solver/engine/laws/backbone.h"
#include "solver/engine/model/model.h"
#include "solver/results/results.h"

#include <array>
#include <vector>

namespace keyblock {

/// Whether a block has come to rest in a dynamic stage (theory, "Sleep").
struct BlockRest {
    bool asleep = false;  // left out of the steps, with its velocity zero
    int quietSteps = 0;  // number of steps in succession in which it hardly moved
    double stepError = 0.0;  // what steps may leave unbalanced on it, when it fell asleep [N]
    /// Change of the force along and across `BlockMotion::axis` [N] and of the moment [N m] since it fell asleep.
    Eigen::Vector3d change = Eigen::Vector3d::Zero();

    bool operator==(const BlockRest&) const = default;
};

struct BlockMotion {
    Point centroid{0.0, 0.0};  // relative to the model's origin [m]
    double angle = 0.0;  // rotation of the block's frame [rad]
    Eigen::Vector3d strain = Eigen::Vector3d::Zero();  // εx, εy, γ in the block's frame
    Eigen::Vector3d preStress = Eigen::Vector3d::Zero();  // stress at zero strain [Pa]
    Vector6 velocity = Vector6::Zero();  // u, v along and across `axis`; r; strain rates in the block's frame
    Point axis{1.0, 0.0};  // direction of the first unknown, rotated if a prescribed motion requires it
    std::vector<Point> corners;  // current positions [m]
    bool fallen = false;
    bool absent = false;  // excavated, or a face plate not installed: no forces act on it and it does not move
    BlockRest rest;  // in dynamic stages only

    bool operator==(const BlockMotion&) const = default;
};

/// Data of a contact at one end of a bonded face of a cell, for joining it with the contact at the other end
/// (contact/bonded_face.h).
struct BondedFace {
    int toward = -1;  // corner of block A at the other end of its edge; −1: not joined, the contact acts at its corner
    double inward = 0.0;  // position between the two corners at which the contact acts, as a fraction
    double spread = 0.0;  // distance between the two contacts' points of action, over the length of the face
    std::array<int, 4> other{-1, -1, -1, -1};  // blockA, corner, blockB and edge of the contact at the other end

    bool operator==(const BondedFace&) const = default;
};

/// Contact of a corner of one block with an edge of another. Its history belongs to the pair of corner and edge, not
/// to its position in the list.
struct Contact {
    int blockA = -1, corner = -1, blockB = -1, edge = -1;
    int joint = -1;  // index into Model::joints
    int opening = -1;  // index into State::openings of the joint or joint set of both its faces; −1: none
    double lockPlace = 0.0;  // position along the edge from which slip is measured [0 … 1]
    double gapOffset = 0.0;  // gap at which the normal force vanishes [m]
    double dilation = 0.0;  // joint opening already taken up by this contact [m]
    double slipOffset = 0.0;  // slip at which the shear force vanishes [m]
    double slip = 0.0;  // accumulated sliding [m]
    double limit = 0.0;  // friction limit last used [N]
    double length = 0.0;  // tributary joint length [m]
    bool bonded = false;  // cohesion and tensile strength are intact
    BondedFace face;
    bool slipped = false;  // friction has dropped to the residual angle
    double slid = 0.0;  // sliding in the last accepted step [m]
    double normalMultiplier = 0.0, shearMultiplier = 0.0;  // forces at zero strain, augmented Lagrangian [N]
    double normalForce = 0.0, shearForce = 0.0;  // last accepted, compression positive [N]
    double gap = 0.0;  // last accepted [m]
    Point position{0.0, 0.0};  // [m]

    bool operator==(const Contact&) const = default;
};

/// Strains at which the links of a glued edge carry no force: normal and shear [m], rotation [rad].
struct GlueState {
    std::array<double, 3> offset{};

    bool operator==(const GlueState&) const = default;
};

/// Bond state of an anchored point along its slot.
struct NodeBond {
    bool bonded = false;  // still on the initial branch of its law
    bool gone = false;  // failed completely along the slot
    double place = 0.0;  // position on the slot at which it was bonded, as a fraction of P2P3 (t0 in the paper)
    double offset = 0.0;  // strain of the slip link at which the force vanishes, for debonded points [m]
    bool sliding = false;  // at its limit when last accepted
    double keptForce = 0.0;  // constant force of a point that does not re-stick, per unit of `share` [N or N/m]
    BackboneState curve;
    double share = 0.0;  // tributary length [m] for laws per length, 1 for laws per node, 0 outside the rock
    double force = 0.0;  // last accepted force of the rock on the node, positive towards the head [N]
    double slip = 0.0;  // last accepted displacement of the rock relative to the bolt along the slot [m]

    bool operator==(const NodeBond&) const = default;
};

struct BoltNode {
    Point x{0.0, 0.0};  // [m]
    double angle = 0.0;  // rotation since the start [rad]
    Eigen::Vector3d velocity = Eigen::Vector3d::Zero();
    int slot = -1;  // index into BoltMotion::slots; −1: in a gap, on a joint or outside the rock
    double normalShare = 0.0;  // tributary length of the normal spring [m]; 1 if its stiffness is per node
    double normalForce = 0.0;  // last accepted force of the normal spring [N]
    double normalOffset = 0.0;  // offset from the slot at which that force is zero, due to crushing or entry off it [m]
    NodeBond bond;

    bool operator==(const BoltNode&) const = default;
};

struct BoltElementState {
    BackboneState steel;
    double strain = 0.0, axialForce = 0.0, shearForce = 0.0, moment1 = 0.0, moment2 = 0.0;  // last accepted, per bolt
    double bend = 0.0;  // p1 of the beam minus its plastic part at the start of the last accepted step [rad]
    double bendLimit = 0.0;  // limit of the bending force for p1 in that step [N m]
    double hingeBend = 0.0, hingeSway = 0.0;  // p1 and p2 at which their forces vanish [rad]
    bool yielded = false;
    bool hinged = false;
    bool ruptured = false;

    bool operator==(const BoltElementState&) const = default;
};

struct BoltMotion {
    std::vector<BoltNode> nodes;
    std::vector<BoltElementState> elements;
    std::vector<Slot> slots;  // slots of the model, and those in blocks entered later
    std::vector<char> leftSlot;  // per slot: true once reported as pulled out
    bool plateHolds = false;  // the face plate has not failed
    double plateNormal = 0.0, plateShear = 0.0;  // last accepted forces [N]
    bool tensioning = false;  // the plate force equals the pretension; not locked off yet
    double plateStretch = 0.0, plateOffset = 0.0;  // normal spring: last accepted strain, and strain at zero force [m]
    double plateShearOffset = 0.0;  // strain of the plate's shear spring at zero force [m]
    StrengthFactors strength;  // strength factors in this stage
    double plasticEnergy = 0.0, bondEnergy = 0.0;  // dissipated since the start [J]
    bool lost = false;
    bool absent = false;  // not installed yet, or removed

    bool operator==(const BoltMotion&) const = default;
};

/// Energies summed step by step [J]. The energy balance is evaluated when they are reported.
struct EnergyLedger {
    double friction = 0.0, plastic = 0.0, released = 0.0, damped = 0.0, external = 0.0;
};

/// State of a point support.
struct SupportState {
    bool quiet = false;  // released, because it lies on a viscous boundary
    Point force{0.0, 0.0};  // force on the block at release [N]
    Point offset{0.0, 0.0};  // displacement from the initial position at which its force equals the preload [m]

    bool operator==(const SupportState&) const = default;
};

struct State {
    std::vector<BlockMotion> blocks;
    std::vector<Contact> contacts;
    std::vector<SupportState> supports;  // per point support of the model; empty: all in the initial state
    std::vector<GlueState> glue;  // per glued edge of the model
    std::vector<BoltMotion> bolts;
    std::vector<double> openings;  // of joint materials, then of the scene's joints and joint sets [m]; empty: none
    std::vector<double> acceleration;  // per unknown; empty if the time scheme does not use accelerations
    EnergyLedger energy;
    double startEnergy = 0.0;  // energy stored before anything moved [J]
    long step = 0;
};

/// True if blocks, bolts, contacts, supports and all forces are the same in two states. The number of the step and the
/// energies are not compared. While blocks may fall asleep, `BlockRest` differs from step to step.
bool isSameConfiguration(const State& a, const State& b);

/// Sets all velocities to zero.
void stopMotion(State& state);

/// True if the bolt is present and not lost.
inline bool acts(const BoltMotion& bolt) { return !bolt.lost && !bolt.absent; }

/// Initial state of a bolt: straight, unstressed and not assigned to any block yet.
BoltMotion boltAtRest(const BoltModel& bolt);

/// Initial state: blocks and bolts at rest at their positions in the scene.
State makeState(const Model& model);

/// Sets the corners from centroid, angle and strain.
void placeCorners(const BlockModel& block, BlockMotion& motion);

/// Current position of a point fixed in the block.
/// \param place the initial position relative to the centroid [m].
Point materialPoint(const BlockMotion& motion, const Point& place);

/// Initial position, relative to the centroid, of the point of the block that is now at `x` [m].
Point materialPlace(const BlockMotion& motion, const Point& x);

/// Data of a block for evaluating `displacementMatrix` at many of its points.
struct BlockFrame {
    Point centroid, axis;
    Eigen::Matrix2d rotation;
    Eigen::Matrix2d toFirstShape;  // maps a current vector from the centroid to the initial shape
};

BlockFrame frameOf(const BlockMotion& motion);

/// Matrix T(x) of a block. The displacement at the current position `x` [m] is T(x)·d for a small displacement
/// d = (u, v, r, εx, εy, γ) of the block, with strains in the block's frame. It is the derivative of `moveBlock`.
Eigen::Matrix<double, 2, 6> displacementMatrix(const BlockFrame& frame, const Point& x);
Eigen::Matrix<double, 2, 6> displacementMatrix(const BlockMotion& motion, const Point& x);

/// Current stress (σx, σy, τ) of the block in the axes of its own rotating frame [Pa].
Eigen::Vector3d frameStress(const BlockModel& block, const BlockMotion& motion);

/// Rotates the axes of the two translational unknowns so that the first is along `axis`. The components of the velocity
/// are converted to the new axes; the motion of the block does not change.
void turnUnknowns(BlockMotion& motion, const Point& axis);

/// Velocity of the centroid in global axes [m/s].
Point centroidVelocity(const BlockMotion& motion);

/// Moves the block by the displacement `d` = (u, v, r, εx, εy, γ) of a step. The rotation r is applied exactly, not
/// linearised.
void moveBlock(const BlockModel& block, BlockMotion& motion, const Vector6& d);

}  // namespace keyblock
