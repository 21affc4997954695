// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The results of a run as plain values: events, frames, history rows, energies
// and solver diagnostics. Every table, store and figure is made from
// these; the engine fills them in and keeps no copy. SI units throughout.
#pragma once

#include "geometry/point.h"
#include "solver/results/step_work.h"
#include "solver/scene/event_kinds.h"

#include <array>
#include <string>
#include <vector>

namespace keyblock {

/// A failure or other discrete event. The forces are given for the state just before the event. Indices that do not
/// apply are −1.
struct Event {
    int stage = 0;
    double time = 0.0;  // [s], or pseudo-time 0 … 1
    long step = 0;
    EventKind kind = EventKind::Debonding;
    int bolt = -1;
    int node = -1;  // counted from 0 at the far end
    int element = -1;  // counted from 0 at the far end
    int block = -1;
    int otherBlock = -1;  // the second block of a joint event
    Point position{0.0, 0.0};  // [m]
    double axialForce = 0.0;  // [N] tension positive; at a node: that of the adjacent element with the larger |N|
    double shearForce = 0.0;  // [N]
    double anchorForce = 0.0;  // [N] positive if the rock pulls the bolt towards its head
    double slip = 0.0;  // [m] rock displacement minus bolt displacement along the axis
    long historyRow = -1;  // index of the history row just before the event, set by the sink; −1: none
    long cause = -1;  // index of the event whose release triggered this one; −1: triggered by the load

    bool operator==(const Event&) const = default;
};

struct BlockState {
    Point centroid{0.0, 0.0};  // [m]
    Point displacement{0.0, 0.0};  // [m] since the start or the last `zero_displacements`
    double rotation = 0.0;  // [rad] since the start or the last `zero_displacements`
    std::array<double, 3> stress{};  // sxx, syy, sxy [Pa], global axes, tension positive
    Point velocity{0.0, 0.0};  // [m/s]
    double area = 0.0;  // [m²]; 0 for an inactive (excavated or removed) block, of which nothing else is stored
    double weight = 0.0;  // [N]
    std::vector<Point> points;  // current positions of the corners [m]

    bool operator==(const BlockState&) const = default;
};

enum class ContactState { Open, Sliding, Locked, Bonded };

struct ContactFrame {
    int blockA = -1;  // block with the corner
    int blockB = -1;  // block with the edge
    int jointMaterial = -1;  // index into the scene's joint materials, `builtInJoint` or `intactJoint`
    Point position{0.0, 0.0};  // [m]
    Point normal{0.0, 0.0};  // current outward unit normal of block b's edge; compression pushes block a along it
    ContactState state = ContactState::Open;
    double normalForce = 0.0;  // [N] compression positive
    double shearForce = 0.0;  // [N] positive if it pushes block a to the right of `normal`
    double penetration = 0.0;  // [m] positive if the corner is inside block b
    double slip = 0.0;  // [m]

    bool operator==(const ContactFrame&) const = default;
};

enum class NodeState { Bonded, Slipping, Gone, Free };

/// A node of a bolt. The axial and shear forces are taken from the element that starts at the node. At the last node,
/// they are the normal and shear forces on the face plate.
struct BoltNodeFrame {
    double s = 0.0;  // [m] from the far end, unstrained
    Point position{0.0, 0.0};  // [m]
    int block = -1;  // block that contains the node; −1: in a gap, on a joint or outside the rock
    bool real = false;  // true: real anchor; false: artificial anchor
    NodeState state = NodeState::Free;
    double axialForce = 0.0;  // [N]
    double shearForce = 0.0;  // [N]
    double moment = 0.0;  // [N m] at the node
    double anchorForce = 0.0;  // [N]
    double slip = 0.0;  // [m]
    double bondStrength = 0.0;  // [N] peak bond force at the current embedment and confinement; 0: no bond, or no limit
    double bondResidual = 0.0;  // [N] residual bond force after slip begins; 0: none
    bool ruptured = false;  // the element that starts at the node is broken

    bool operator==(const BoltNodeFrame&) const = default;
};

struct BoltFrame {
    std::vector<BoltNodeFrame> nodes;  // empty if the bolt is not installed or was removed
    bool plateHolds = false;
    bool lost = false;  // the whole bolt has failed (expansion shell)
    double elasticEnergy = 0.0;  // [J] stored now, for the thickness of the model
    double plasticEnergy = 0.0;  // [J] dissipated since the start in yielding steel, plastic hinges and crushed rock
    double bondEnergy = 0.0;  // [J] dissipated since the start by sliding anchors and failing bonds

    bool operator==(const BoltFrame&) const = default;
};

/// The value of largest magnitude of a bolt quantity over the run, with the location on the bolt and the time at which
/// it occurred.
struct BoltPeak {
    double value = 0.0;  // signed
    double at = 0.0;  // [m] from the far end, unstrained
    int stage = -1;  // −1: no value other than zero so far
    double time = 0.0;  // within the stage

    bool operator==(const BoltPeak&) const = default;
};

/// Largest forces in a bolt over the run so far, from every accepted step and the state before every failure. The
/// forces are per bolt, not per metre of section. A utilisation is 1 when the strength is reached, and negative if the
/// bolt has no such strength.
struct BoltExtremes {
    BoltPeak axialForce, shearForce;  // [N] located at the middle of the element
    BoltPeak moment;  // [N m] located at the node
    BoltPeak steel;  // utilisation of the steel by axial force and moment together
    BoltPeak shear, bond, plate;  // utilisation of the shear strength, the bond of a node and the face plate

    bool operator==(const BoltExtremes&) const = default;
};

/// Extreme value of a block quantity over the run so far, with the time at which it occurred.
struct BlockPeak {
    double value = 0.0;
    int stage = -1;  // −1: none yet
    double time = 0.0;  // within the stage

    bool operator==(const BlockPeak&) const = default;
};

/// Extremes of a block over the run so far, from every accepted step and the state before every failure.
struct BlockExtremes {
    BlockPeak displacement;  // largest since the start or the last `zero_displacements` [m]
    BlockPeak velocity;  // largest [m/s]
    BlockPeak sigma1, sigma3;  // largest major and smallest minor principal stress, compression positive [Pa]

    bool operator==(const BlockExtremes&) const = default;
};

/// Energy balance of the run so far [J].
struct Energy {
    double kinetic = 0.0, strain = 0.0, contact = 0.0, bolt = 0.0, friction = 0.0, plastic = 0.0, released = 0.0,
           damped = 0.0, external = 0.0;
    double balanceError = 0.0;  // residual of the balance divided by its largest term

    bool operator==(const Energy&) const = default;
};

enum class ForceSource { Weight, Contact, Bolt, Support, Load, Wall, Glue, Dashpot, Inertia };

/// A single force on a block.
struct BlockForce {
    int block = -1;
    ForceSource source = ForceSource::Weight;
    int other = -1;  // the other block of a contact or bond, or the bolt; −1: neither
    Point position{0.0, 0.0};  // point of application [m]
    Point force{0.0, 0.0};  // force on the block [N]
    double moment = 0.0;  // moment of force and couple about the block's centroid, counter-clockwise positive [N m]

    bool operator==(const BlockForce&) const = default;
};

/// Body forces on a block: its weight and its inertia forces, both proportional to its mass.
struct BodyForce {
    Point weight{0.0, 0.0};  // from gravity and body accelerations, as far as they are applied [N]
    Point inertia{0.0, 0.0};  // −m·a over the step of the frame; 0 in a static stage [N]
    double inertiaMoment = 0.0;  // moment of inertia forces over the step of the frame; 0 in a static stage [N m]

    bool operator==(const BodyForce&) const = default;
};

/// Contact force that acts over a dynamic step. The moments are taken about the centroids of the blocks at the positions
/// used to compute the step.
struct ContactStepForce {
    Point force{0.0, 0.0};  // force on block a; the opposite force acts on block b [N]
    double momentA = 0.0, momentB = 0.0;  // moments on blocks a and b about their centroids [N m]

    bool operator==(const ContactStepForce&) const = default;
};

/// The forces on the blocks that cannot be derived from the contacts of a frame. For the list of all forces, see
/// `blockForces` (block_forces.h).
struct FrameForces {
    std::vector<BodyForce> bodies;  // one per block; empty if no forces were stored
    std::vector<ContactStepForce> contacts;  // dynamic stage: one per contact; static: empty, see `Frame::contacts`
    std::vector<Point> nodes;  // one per node of all bolts: force of its anchor on the block around it [N]
    std::vector<BlockForce> others;  // all other forces; a bond between cells is listed for one of the two cells only

    bool operator==(const FrameForces&) const = default;
};

struct Frame {
    int stage = 0;
    double time = 0.0;
    long step = 0;
    std::vector<BlockState> blocks;
    std::vector<ContactFrame> contacts;
    std::vector<BoltFrame> bolts;
    Energy energy;
    FrameForces forces;
    std::vector<BoltExtremes> extremes;  // one per bolt, from the start of the run to this frame
    std::vector<BlockExtremes> blockExtremes;  // one per block, from the start of the run to this frame
    long events = 0;  // number of events so far, which distinguishes frames at the same time before and after an event

    bool operator==(const Frame&) const = default;
};

/// One row of the history: one value per column of `HistoryColumns`.
struct HistoryRow {
    int stage = 0;
    double time = 0.0;
    long step = 0;
    std::vector<double> values;

    bool operator==(const HistoryRow&) const = default;
};

/// Names of the columns of the history. The columns of the monitors come first, as printed in the history table (e.g.
/// `crown_ux_m`, `B1_force_N`). They are followed by one column for each quantity of every bolt (`BOLT.axial_force`, …
/// in the order of `BoltQuantity`), which contains the signed value of largest magnitude along the bolt. The scene's
/// `quantities` are read from all these columns.
struct HistoryColumns {
    std::vector<std::string> names;
    int monitorValues = 0;  // number of leading columns shown in the history table

    bool operator==(const HistoryColumns&) const = default;
};

enum class Outcome { Equilibrium, Duration, Limit, Collapse, Stopped, Failed, Displaced, Undecided };

/// How an unstable block moves. `Follows` means that other blocks set it in motion.
enum class Movement { Slides, Falls, Topples, Follows };

/// Movement of an unstable block, or of the block with the largest displacement.
struct UnstableBlock {
    int block = -1;  // index in the frames; for a block divided into cells, that of its first cell
    Movement mode = Movement::Slides;
    double moved = 0.0;  // largest corner displacement [m] relative to the neighbours at the start of the stage
    double weight = 0.0;  // [N] for the thickness of the model

    bool operator==(const UnstableBlock&) const = default;
};

/// The block or bolt node with the largest relative unbalanced force at the last equilibrium of a static stage.
struct WorstBalance {
    int block = -1;  // index in the frames; −1: nothing was checked, or it is a bolt node
    double share = 0.0;  // unbalanced force divided by the block's weight or its substitute
    double force = 0.0;  // unbalanced force [N]

    bool operator==(const WorstBalance&) const = default;
};

/// Solver diagnostics of a stage.
struct Health {
    long steps = 0;
    long passes = 0;  // iterations
    long stepCuts = 0;  // time-step or increment reductions, without `energyCuts`
    long energyCuts = 0;  // steps shortened because of their energy error
    StepWork work;
    long awake = 0;  // blocks that moved with the steps of a dynamic stage, summed over the steps
    long movable = 0;  // the same with the blocks that slept
    double maxPenetrationRatio = 0.0;  // largest penetration divided by the size of the smaller block
    double maxResidual = 0.0;  // largest accepted unbalanced force divided by the magnitude of the acting forces
    double balanceError = 0.0;
    WorstBalance worst;

    bool operator==(const Health&) const = default;
};

/// Diagnostics of the latest step, for display only; the run does not depend on them. Block indices are −1 if there is
/// no such block.
struct StepHealth {
    int passes = 0;  // iterations
    int worst = -1;  // block with the largest relative unbalanced force
    double residual = 0.0;  // accepted unbalanced force divided by the magnitude of the acting forces
    double penetrationRatio = 0.0;  // largest penetration divided by the size of the smaller block
    int penetrated = -1;  // block to which the penetrating corner belongs
    long searched = 0;  // solves so far in the current search for equilibrium; 0 if there is none or in a dynamic stage
    int moving = -1;  // block that has moved most, relative to its size, during the search
    double moved = 0.0;  // displacement of that block [m]
};

struct StageResult {
    int stage = 0;
    Outcome outcome = Outcome::Equilibrium;
    double time = 0.0;  // time reached
    long steps = 0;
    std::string message;  // reason for instability, failure or no verdict: blocks or nodes concerned, and what to do
    std::vector<int> blocks;  // blocks that move or are not in equilibrium
    std::vector<UnstableBlock> unstable;  // blocks that make the stage unstable
    UnstableBlock farthest;  // moved most for its size among the blocks that the verdict considers
    std::vector<int> loose;  // blocks removed in this stage because they are too small to affect the verdict
    Health health;

    bool operator==(const StageResult&) const = default;
};

/// All results of a run, kept in memory for tests and verification; the run store keeps the same data on disk.
struct Results {
    HistoryColumns columns;
    std::vector<HistoryRow> history;
    std::vector<Event> events;
    std::vector<Frame> frames;
    std::vector<StageResult> stages;

    bool operator==(const Results&) const = default;
};

}  // namespace keyblock
