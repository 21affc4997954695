// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Everything that changes while a scene is run, as plain values: copying it is
// the checkpoint before a step, assigning it back undoes the step.
#pragma once

#include "solver/engine/laws/backbone.h"
#include "solver/engine/model/model.h"
#include "solver/results/results.h"

#include <array>
#include <vector>

namespace keyblock {

struct BlockMotion {
    Point centroid{0.0, 0.0};  // [m] from the model's origin
    double angle = 0.0;  // of the block's frame [rad]
    Eigen::Vector3d strain = Eigen::Vector3d::Zero();  // εx, εy, γ in that frame
    Eigen::Vector3d preStress = Eigen::Vector3d::Zero();  // stress without strain [Pa]
    Vector6 velocity = Vector6::Zero();  // u, v along `axis` and across it; r; strains in the frame
    Point axis{1.0, 0.0};  // direction of the first unknown, turned where a motion prescribes it
    std::vector<Point> corners;  // where they are now [m]
    bool fallen = false;
    bool absent = false;  // excavated, or a plate that is not installed: nothing acts on it and it does not move

    bool operator==(const BlockMotion&) const = default;
};

/// Of a contact at an end of a bonded face of a cell (contact/bonded_face.h).
struct BondedFace {
    int toward = -1;  // corner of block A at the other end of its edge; −1: the contact acts at its corner
    double inward = 0.0;  // share of the way there at which it acts
    double spread = 0.0;  // from place to place of the two contacts, over the length of the face
    std::array<int, 4> other{-1, -1, -1, -1};  // blockA, corner, blockB, edge of the contact at the other end

    bool operator==(const BondedFace&) const = default;
};

/// A corner of one block before an edge of another. Its history belongs to the
/// pair of features, whatever its place in the list.
struct Contact {
    int blockA = -1, corner = -1, blockB = -1, edge = -1;
    int joint = -1;  // row of Model::joints
    int opening = -1;  // row of State::openings of the joint or set that both its faces are on; −1: none
    double lockPlace = 0.0;  // where along the edge the corner was locked [0 … 1]
    double gapOffset = 0.0;  // gap at which the normal force vanishes [m]
    double dilation = 0.0;  // of its joint that this has taken up [m]
    double slipOffset = 0.0;  // slip at which the shear force vanishes [m]
    double slip = 0.0;  // accumulated sliding [m]
    double limit = 0.0;  // friction limit last used [N]
    double length = 0.0;  // of joint tributary to this corner [m]
    bool bonded = false;  // cohesion and tension not lost yet
    BondedFace face;
    bool slipped = false;  // friction has fallen to its residual angle
    double slid = 0.0;  // in the last accepted step [m]
    double normalMultiplier = 0.0, shearMultiplier = 0.0;  // forces without strain, augmented Lagrangian [N]
    double normalForce = 0.0, shearForce = 0.0;  // last accepted [N], compression positive
    double gap = 0.0;  // last accepted [m]
    Point position{0.0, 0.0};  // [m]

    bool operator==(const Contact&) const = default;
};

/// Strains at which the links of a glued edge carry nothing: normal, shear [m], turn [rad].
struct GlueState {
    std::array<double, 3> offset{};

    bool operator==(const GlueState&) const = default;
};

/// Tangential state of an anchored point.
struct NodeBond {
    bool bonded = false;  // still on its first branch
    bool gone = false;  // nothing left in the tangent
    double place = 0.0;  // where on the slot it was bonded, a share of P2P3 (the paper's t0)
    double offset = 0.0;  // slip at which the force vanishes [m], sliding points
    bool sliding = false;  // at its limit when last accepted
    double keptForce = 0.0;  // force of a point that does not stick again, per share [N or N/m]
    BackboneState curve;
    double share = 0.0;  // embedded length [m] for laws per length, 1 for laws per node, 0 out of the rock
    double force = 0.0;  // last accepted, of the rock on the node towards the head [N]
    double slip = 0.0;  // last accepted, rock minus bolt along the slot [m]

    bool operator==(const NodeBond&) const = default;
};

struct BoltNode {
    Point x{0.0, 0.0};  // [m]
    double angle = 0.0;  // [rad] turned since the start
    Eigen::Vector3d velocity = Eigen::Vector3d::Zero();
    int slot = -1;  // row of BoltMotion::slots; −1: in a gap, on a joint or outside
    double normalShare = 0.0;  // embedded length [m], or 1, tributary to the normal spring
    double normalForce = 0.0;  // last accepted, of the normal spring [N]
    double normalOffset = 0.0;  // distance from the slot at which that vanishes: crushed rock, or where it came in [m]
    NodeBond bond;

    bool operator==(const BoltNode&) const = default;
};

struct BoltElementState {
    BackboneState steel;
    double strain = 0.0, axialForce = 0.0, shearForce = 0.0, moment1 = 0.0, moment2 = 0.0;  // last accepted, per bolt
    double bend = 0.0;  // the beam's p1 over what was plastic of it when the last accepted step began [rad]
    double bendLimit = 0.0;  // of its force in that step [N m]
    double hingeBend = 0.0, hingeSway = 0.0;  // p1 and p2 at which their forces vanish [rad]
    bool yielded = false;
    bool hinged = false;
    bool ruptured = false;

    bool operator==(const BoltElementState&) const = default;
};

struct BoltMotion {
    std::vector<BoltNode> nodes;
    std::vector<BoltElementState> elements;
    std::vector<Slot> slots;  // the model's, and those of blocks entered later
    std::vector<char> leftSlot;  // reported as pulled out
    bool plateHolds = false;
    double plateNormal = 0.0, plateShear = 0.0;  // [N] last accepted
    bool tensioning = false;  // the plate pulls with the pretension and is not locked off yet
    double plateStretch = 0.0, plateOffset = 0.0;  // of the normal spring: last accepted, and where it vanishes [m]
    double plateShearOffset = 0.0;  // where the plate's shear spring vanishes [m]
    StrengthFactors strength;  // in this stage
    double plasticEnergy = 0.0, bondEnergy = 0.0;  // [J] used since the start
    bool lost = false;
    bool absent = false;  // not installed yet, or removed
};

/// Energies summed step by step; their balance is found when they are reported.
struct EnergyLedger {
    double friction = 0.0, plastic = 0.0, released = 0.0, damped = 0.0, external = 0.0;
};

/// What a stage has made of a point support.
struct SupportState {
    bool quiet = false;  // on a viscous boundary: it is released
    Point force{0.0, 0.0};  // that it gave when it ceased to [N]
    Point offset{0.0, 0.0};  // where it gives its preload, beside where it was at the start [m]

    bool operator==(const SupportState&) const = default;
};

struct State {
    std::vector<BlockMotion> blocks;
    std::vector<Contact> contacts;
    std::vector<SupportState> supports;  // a row per point support of the model; empty: as at the start
    std::vector<GlueState> glue;  // a row per glued edge of the model
    std::vector<BoltMotion> bolts;
    std::vector<double> openings;  // dilation of joint materials (rows of Model::joints), then joints; empty: none [m]
    std::vector<double> acceleration;  // of every unknown, where the scheme carries them; else empty
    EnergyLedger energy;
    double startEnergy = 0.0;  // stored before anything moved [J]
    long step = 0;
};

/// True where the bolt is present and not lost.
inline bool acts(const BoltMotion& bolt) { return !bolt.lost && !bolt.absent; }

/// A bolt as it is before anything moved: straight, unstressed, in no block yet.
BoltMotion boltAtRest(const BoltModel& bolt);

/// Blocks and bolts at rest where the scene has them.
State makeState(const Model& model);

/// Corners from centroid, angle and strain.
void placeCorners(const BlockModel& block, BlockMotion& motion);

/// Where a point fixed in the block is now. \param place from the centroid at the start [m].
Point materialPoint(const BlockMotion& motion, const Point& place);

/// The point of the block's frame at the start that is now at `x`.
Point materialPlace(const BlockMotion& motion, const Point& x);

/// What `displacementMatrix` needs of a block, for many points of the same one.
struct BlockFrame {
    Point centroid, axis;
    Eigen::Matrix2d rotation;
    Eigen::Matrix2d toFirstShape;  // takes an arm from the centroid back to the first shape
};

BlockFrame frameOf(const BlockMotion& motion);

/// T(x): displacement at `x` from (u, v, r, εx, εy, γ), strains in the block's frame; the derivative of `moveBlock`.
Eigen::Matrix<double, 2, 6> displacementMatrix(const BlockFrame& frame, const Point& x);
Eigen::Matrix<double, 2, 6> displacementMatrix(const BlockMotion& motion, const Point& x);

/// Stress in the block's frame [Pa].
Eigen::Vector3d frameStress(const BlockModel& block, const BlockMotion& motion);

/// Turns the pair of translation unknowns to `axis`, keeping the velocity.
void turnUnknowns(BlockMotion& motion, const Point& axis);

/// Velocity of the centroid in global axes [m/s].
Point centroidVelocity(const BlockMotion& motion);

/// Moves the block by one step's displacement, turning it exactly.
void moveBlock(const BlockModel& block, BlockMotion& motion, const Vector6& d);

}  // namespace keyblock
