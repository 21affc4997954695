// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a run produces, as plain values: events, frames, history rows, energies
// and solver diagnostics. Every table, store and figure is made from
// these; the engine fills them and keeps no copy. SI units throughout.
#pragma once

#include "geometry/point.h"
#include "solver/results/step_work.h"
#include "solver/scene/event_kinds.h"

#include <array>
#include <string>
#include <vector>

namespace keyblock {

/// A failure. Forces are those just before the release; −1 marks an index that does not apply.
struct Event {
    int stage = 0;
    double time = 0.0;  // [s], or pseudo-time 0 … 1
    long step = 0;
    EventKind kind = EventKind::Debonding;
    int bolt = -1;
    int node = -1;  // from 0 at the far end
    int element = -1;  // from 0 at the far end
    int block = -1;
    int otherBlock = -1;  // the second block of a joint event
    Point position{0.0, 0.0};  // [m]
    double axialForce = 0.0;  // [N] tension positive; of a node: the larger |N| of the adjacent elements
    double shearForce = 0.0;  // [N]
    double anchorForce = 0.0;  // [N] positive when the rock pulls the bolt towards its head
    double slip = 0.0;  // [m] rock minus bolt along the axis
    long historyRow = -1;  // the history row just before it, from 0; the sink that keeps both counts; −1: none
    long cause = -1;  // the event of the run, from 0, whose release set this one over; −1: the load itself did

    bool operator==(const Event&) const = default;
};

struct BlockState {
    Point centroid{0.0, 0.0};  // [m]
    Point displacement{0.0, 0.0};  // [m] since the start or the last `zero_displacements`
    double rotation = 0.0;  // [rad] likewise
    std::array<double, 3> stress{};  // sxx, syy, sxy [Pa], global axes, tension positive
    Point velocity{0.0, 0.0};  // [m/s]
    double area = 0.0;  // [m²]; 0 of a block that is not there, with nothing else stored of it
    double weight = 0.0;  // [N]
    std::vector<Point> points;  // the corners where they are now [m]

    bool operator==(const BlockState&) const = default;
};

enum class ContactState { Open, Sliding, Locked, Bonded };

struct ContactFrame {
    int blockA = -1;  // holds the corner
    int blockB = -1;  // holds the edge
    int jointMaterial = -1;  // index into the scene's joint materials, `builtInJoint` or `intactJoint`
    Point position{0.0, 0.0};  // [m]
    Point normal{0.0, 0.0};  // unit vector in which compression pushes block a: outward from b's edge as it lies now
    ContactState state = ContactState::Open;
    double normalForce = 0.0;  // [N] compression positive
    double shearForce = 0.0;  // [N] positive where it pushes block a to the right of `normal`
    double penetration = 0.0;  // [m] positive when the corner is inside
    double slip = 0.0;  // [m]

    bool operator==(const ContactFrame&) const = default;
};

enum class NodeState { Bonded, Slipping, Gone, Free };

/// One node of a bolt; the element's forces are those of the element that starts here,
/// the last node's are the plate's (axial force: its normal force, shear force: its shear).
struct BoltNodeFrame {
    double s = 0.0;  // [m] from the far end, unstrained
    Point position{0.0, 0.0};  // [m]
    int block = -1;  // −1: in a gap, on a joint or outside
    bool real = false;  // real or artificial anchor
    NodeState state = NodeState::Free;
    double axialForce = 0.0;  // [N]
    double shearForce = 0.0;  // [N]
    double moment = 0.0;  // [N m] at the node
    double anchorForce = 0.0;  // [N]
    double slip = 0.0;  // [m]
    double bondStrength = 0.0;  // [N] at which its bond fails, as embedded and clamped now; 0: none, or no limit
    double bondResidual = 0.0;  // [N] that the bond keeps once it slides; 0: none
    bool ruptured = false;  // the element that starts here is broken

    bool operator==(const BoltNodeFrame&) const = default;
};

struct BoltFrame {
    std::vector<BoltNodeFrame> nodes;  // none of a bolt that is not there
    bool plateHolds = false;
    bool lost = false;  // the whole bolt (expansion shell)
    double elasticEnergy = 0.0;  // [J] held now, over the model's thickness
    double plasticEnergy = 0.0;  // [J] taken since the start by steel, hinges and crushed rock
    double bondEnergy = 0.0;  // [J] dissipated by sliding anchors and failing bonds

    bool operator==(const BoltFrame&) const = default;
};

/// The value of largest magnitude over the run, with its location on the bolt and its time.
struct BoltPeak {
    double value = 0.0;  // with its sign
    double at = 0.0;  // [m] from the far end, unstrained
    int stage = -1;  // −1: never above zero
    double time = 0.0;  // within the stage

    bool operator==(const BoltPeak&) const = default;
};

/// The largest forces in a bolt over the run so far, at every accepted step and before every failure; per bolt, not
/// per metre of the section. A use is the share of a strength, 1 where it is reached; below zero: no such strength.
struct BoltExtremes {
    BoltPeak axialForce, shearForce;  // [N] at the middle of the element
    BoltPeak moment;  // [N m] at the node
    BoltPeak steel;  // use of the steel by axial force and moment together
    BoltPeak shear, bond, plate;  // use of the shear strength, of a node's bond and of the face plate

    bool operator==(const BoltExtremes&) const = default;
};

/// The extreme value of a block over the run so far, with its time.
struct BlockPeak {
    double value = 0.0;
    int stage = -1;  // −1: none yet
    double time = 0.0;  // within the stage

    bool operator==(const BlockPeak&) const = default;
};

/// Extremes of a block over the run so far, at every accepted step and before every failure.
struct BlockExtremes {
    BlockPeak displacement;  // largest since the start or the last `zero_displacements` [m]
    BlockPeak velocity;  // largest [m/s]
    BlockPeak sigma1, sigma3;  // largest major and smallest minor principal stress, compression positive [Pa]

    bool operator==(const BlockExtremes&) const = default;
};

/// Energies since the start of the run [J].
struct Energy {
    double kinetic = 0.0, strain = 0.0, contact = 0.0, bolt = 0.0, friction = 0.0, plastic = 0.0, released = 0.0,
           damped = 0.0, external = 0.0;
    double balanceError = 0.0;  // what is left, over the largest term

    bool operator==(const Energy&) const = default;
};

enum class ForceSource { Weight, Contact, Bolt, Support, Load, Wall, Glue, Dashpot, Inertia };

/// A single force on a block.
struct BlockForce {
    int block = -1;
    ForceSource source = ForceSource::Weight;
    int other = -1;  // the other block of a contact or bond; the bolt; −1: neither
    Point position{0.0, 0.0};  // where it acts [m]
    Point force{0.0, 0.0};  // on the block [N]
    double moment = 0.0;  // of force and couple about the block's centroid, counter-clockwise positive [N m]

    bool operator==(const BlockForce&) const = default;
};

/// Forces in proportion to the mass of a block.
struct BodyForce {
    Point weight{0.0, 0.0};  // of gravity and of accelerations that act like it, as much of them as acts [N]
    Point inertia{0.0, 0.0};  // −m·a over the frame's step; 0 at rest [N]
    double inertiaMoment = 0.0;  // likewise [N m]

    bool operator==(const BodyForce&) const = default;
};

/// Force of a contact over a step, where its blocks were in the middle of it.
struct ContactStepForce {
    Point force{0.0, 0.0};  // on block a; its opposite acts on block b [N]
    double momentA = 0.0, momentB = 0.0;  // on either block about its centroid [N m]

    bool operator==(const ContactStepForce&) const = default;
};

/// Single forces on the blocks that the frame's contacts do not give; `blockForces` (block_forces.h) lists all of them.
struct FrameForces {
    std::vector<BodyForce> bodies;  // a row per block; empty: no forces were kept
    std::vector<ContactStepForce> contacts;  // a row per contact of a frame in motion; empty at rest: they are the contacts'
    std::vector<Point> nodes;  // a row per node of all bolts: what its anchor gives the block that holds it [N]
    std::vector<BlockForce> others;  // a bond between cells once: its opposite acts on the other cell

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
    std::vector<BoltExtremes> extremes;  // a row per bolt, from the start of the run to this frame
    std::vector<BlockExtremes> blockExtremes;  // a row per block, likewise
    long events = 0;  // of the run until this frame: the frames just before and after one may have the same time

    bool operator==(const Frame&) const = default;
};

/// One row of the history: a value per column of `HistoryColumns`.
struct HistoryRow {
    int stage = 0;
    double time = 0.0;
    long step = 0;
    std::vector<double> values;

    bool operator==(const HistoryRow&) const = default;
};

/// Names the history's values: first those of the monitors (as the history table
/// prints them, e.g. `crown_ux_m`, `B1_force_N`), then one for each quantity of every bolt
/// (`BOLT.axial_force`, … in the order of `BoltQuantity`: the value of largest
/// magnitude along the bolt, with its sign), which quantities read.
struct HistoryColumns {
    std::vector<std::string> names;
    int monitorValues = 0;  // how many of them the history table shows

    bool operator==(const HistoryColumns&) const = default;
};

enum class Outcome { Equilibrium, Duration, Limit, Collapse, Stopped, Failed, Displaced, Undecided };

/// How an unstable block moves; `Follows`: others set it moving.
enum class Movement { Slides, Falls, Topples, Follows };

/// An unstable block, or the one farthest from where it was.
struct UnstableBlock {
    int block = -1;  // row of the frames; of a block in cells the first
    Movement mode = Movement::Slides;
    double moved = 0.0;  // of the corner that went farthest, seen from what it touched when the stage began [m]
    double weight = 0.0;  // [N] of the whole thickness

    bool operator==(const UnstableBlock&) const = default;
};

/// The block or node farthest from balance at the last equilibrium of a static stage.
struct WorstBalance {
    int block = -1;  // row of the frames; −1: none was judged, or a node of a bolt
    double share = 0.0;  // unbalanced force over the block's weight, or its substitute
    double force = 0.0;  // [N]

    bool operator==(const WorstBalance&) const = default;
};

/// How well the numbers behaved over a stage.
struct Health {
    long steps = 0;
    long passes = 0;
    long stepCuts = 0;
    long energyCuts = 0;  // steps made shorter because their energy did not balance; not among `stepCuts`
    StepWork work;
    double maxPenetrationRatio = 0.0;  // deepest penetration over the size of the block
    double maxResidual = 0.0;  // largest accepted unbalanced force over the forces at play
    double balanceError = 0.0;
    WorstBalance worst;

    bool operator==(const Health&) const = default;
};

/// How the newest step went, for observers; nothing of a run depends on it. Blocks are −1 where there is none.
struct StepHealth {
    int passes = 0;
    int worst = -1;  // block that was balanced worst
    double residual = 0.0;  // accepted, over the forces at play
    double penetrationRatio = 0.0;  // deepest penetration over the size of the block
    int penetrated = -1;  // block there
    long searched = 0;  // solves of the search for equilibrium in progress; 0: none, or in motion
    int moving = -1;  // block that has moved farthest in it
    double moved = 0.0;  // that far [m]
};

struct StageResult {
    int stage = 0;
    Outcome outcome = Outcome::Equilibrium;
    double time = 0.0;  // reached
    long steps = 0;
    std::string message;  // of instability, failure or no verdict: which blocks or nodes, and what to do
    std::vector<int> blocks;  // those that move or do not balance
    std::vector<UnstableBlock> unstable;  // because of which the stage is unstable
    UnstableBlock farthest;  // of those that decide, the one that moved most over its size; −1: none decides
    std::vector<int> loose;  // removed in this stage, because they are too small to decide
    Health health;

    bool operator==(const StageResult&) const = default;
};

/// Everything a run left, kept in memory (tests, verification); the run store keeps the same on disk.
struct Results {
    HistoryColumns columns;
    std::vector<HistoryRow> history;
    std::vector<Event> events;
    std::vector<Frame> frames;
    std::vector<StageResult> stages;

    bool operator==(const Results&) const = default;
};

}  // namespace keyblock
