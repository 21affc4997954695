// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Laws of bolts in whole runs, against closed forms: friction that sticks and
// reverses, anchors that are clamped, pre-tension, dynamic strength.
#include "solver/scene/preset.h"
#include "tests/solver/run/bolt_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace keyblock {
namespace {

constexpr double friction = 20e3;  // [N]

/// Free bar of 0.5 m between an anchor that slips at `friction` and one that does not; opened and closed again by 3 mm.
Scene cyclicPull(bool restick) {
    Scene scene = gapBlocks(0.1);
    BoltType type = linearType(barArea(), 200e9);
    Anchor slipping = anchorAt(0.0, AnchorLaw::Frictional, 50e6);
    slipping.strength = friction;
    slipping.restick = restick;
    type.anchors = {slipping, anchorAt(0.5, AnchorLaw::Elastic, 100e6)};
    addBolt(scene, type, 0.75, 1.25, 10, PlateKind::None);
    Stage stage = pullStage(scene, 0.0, 60);
    stage.motions[0].table = {{0.0, 0.0}, {0.2, 3e-3}, {0.6, -3e-3}, {1.0, 3e-3}};
    scene.stages = {stage};
    return scene;
}

std::vector<Event> eventsOf(const Solved& solved, EventKind kind) {
    std::vector<Event> found;
    for (const Event& event : solved.results.events)
        if (event.kind == kind) found.push_back(event);
    return found;
}

// Elastic–perfectly plastic in the opening: stiffness 1/k = 1/k₁ + L/EA + 1/k₂, limit f. From 0 to U and by 2U back
// and forth the anchor slides 5·(U − f/k); a whole cycle takes 4·f·(U − f/k).
TEST(BoltLaws, FrictionSticksAgainAndReverses) {
    const Solved solved = solve(cyclicPull(true));
    const double flexibility = 1.0 / 50e6 + 0.5 / (200e9 * barArea()) + 1.0 / 100e6;
    const double slide = 3e-3 - friction * flexibility;
    const Frame& last = solved.results.frames.back();
    EXPECT_NEAR(last.energy.friction, 5.0 * friction * slide, 1e-6 * friction * slide);
    EXPECT_NEAR(last.bolts[0].bondEnergy, last.energy.friction, 1e-9 * last.energy.friction);
    EXPECT_NEAR(last.bolts[0].elasticEnergy, 0.5 * friction * friction * flexibility, 1e-3);
    EXPECT_NEAR(reading(solved, "max joint force"), friction, 1e-6 * friction);
    EXPECT_NEAR(reading(solved, "min joint force"), -friction, 1e-6 * friction);
    const std::vector<Event> sticks = eventsOf(solved, EventKind::Restick);
    ASSERT_EQ(sticks.size(), 2u);
    EXPECT_NEAR(sticks[0].time, 0.2, 1e-12);
    EXPECT_NEAR(sticks[1].time, 0.6, 1e-12);
    EXPECT_EQ(sticks[0].node, 0);
    EXPECT_NEAR(sticks[0].anchorForce, -friction, 1e-6 * friction);
    EXPECT_NEAR(sticks[1].anchorForce, friction, 1e-6 * friction);
    EXPECT_EQ(sticks[0].cause, -1);
    EXPECT_EQ(eventsOf(solved, EventKind::Debonding).size(), 1u);
    // On the way back the force falls by 2f over an opening of 2f/k.
    for (std::size_t i = 1; i < solved.results.history.size(); ++i) {
        const HistoryRow& row = solved.results.history[i];
        if (row.time < 0.2 || row.time > 0.6) continue;
        const double back = 3e-3 - row.values[0];
        EXPECT_NEAR(row.values[1], std::max(friction - back / flexibility, -friction), 2e-6 * friction) << row.time;
    }
}

TEST(BoltLaws, WithoutRestickingTheForceStays) {
    const Solved solved = solve(cyclicPull(false));
    EXPECT_TRUE(eventsOf(solved, EventKind::Restick).empty());
    for (const HistoryRow& row : solved.results.history)
        if (row.time > 0.2) {
            EXPECT_NEAR(row.values[1], friction, 1e-6 * friction);
        }
    // When sliding reverses by 2U, the force pulls in the direction of motion: a load's work, no friction.
    const double flexibility = 1.0 / 50e6 + 0.5 / (200e9 * barArea()) + 1.0 / 100e6;
    const double slide = 3e-3 - friction * flexibility + 6e-3;
    EXPECT_NEAR(solved.results.frames.back().energy.friction, friction * slide, 1e-5 * friction * slide);
    for (std::size_t i = 1; i < solved.results.frames.size(); ++i)
        EXPECT_GE(solved.results.frames[i].energy.friction, solved.results.frames[i - 1].energy.friction * (1.0 - 1e-12));
    EXPECT_LT(std::abs(solved.results.stages[0].health.balanceError), 1e-6);
}

/// The head is the only node in the block that is pulled, and carries what presses that block across the bolt.
Scene clampedHead(AnchorLaw law, double cohesion, double residual, double angle) {
    Scene scene = gapBlocks(0.05);
    BoltType type = linearType(barArea(), 200e9);
    type.normalStiffness = 1e9;
    Anchor head = anchorAt(0.6, law, 50e6);
    head.strength = cohesion;
    if (law == AnchorLaw::PeakResidual) head.residual = residual;
    head.frictionAngle = angle;
    Anchor root = anchorRange(Per::Node, AnchorLaw::Elastic, 1e9, std::nullopt, 0.0);
    root.to = BoltPlace{false, 0.45};
    type.anchors = {root, head};
    addBolt(scene, type, 0.48, 1.08, 6, PlateKind::None);
    scene.monitors.back().at = 0.6;
    scene.monitors.back().quantity = BoltQuantity::AnchorForce;
    Stage press = loadStage(scene, 0.0, 4), pull = pullStage(scene, 2e-3, 40), more = loadStage(scene, 0.0, 4);
    press.loads[0].force = {0.0, -5e3};
    press.motions = {pull.motions[0]};
    press.motions[0].table = {{0.0, 0.0}};
    more.name = "more";
    more.loads[0].table = {{0.0, 0.625}, {1.0, 1.0}};  // from the 5 kN that act
    more.loads[0].force = {0.0, -8e3};  // in place of the first
    scene.stages = {press, pull, more};
    return scene;
}

// N is what the loads press, whatever the bolt does: strength c + N·tan φ, then c' + N·tan φ.
TEST(BoltLaws, AClampedAnchorHoldsByFriction) {
    const double tanPhi = std::tan(30.0 * std::numbers::pi / 180.0);
    const Solved solved = solve(clampedHead(AnchorLaw::PeakResidual, 3e3, 1e3, 30.0));
    for (const StageResult& stage : solved.results.stages) EXPECT_EQ(stage.outcome, Outcome::Equilibrium);
    EXPECT_NEAR(eventsOf(solved, EventKind::Debonding).at(0).anchorForce, 3e3 + 5e3 * tanPhi, 1e-6 * 3e3);
    for (const Frame& frame : solved.results.frames)
        if (frame.stage == 0 && frame.time > 0.99) {
            const BoltNodeFrame& head = frame.bolts[0].nodes.back();
            EXPECT_NEAR(head.bondStrength, 3e3 + 5e3 * tanPhi, 1e-6 * 3e3);
            EXPECT_NEAR(head.bondResidual, 1e3 + 5e3 * tanPhi, 1e-6 * 3e3);
        }
    std::vector<double> ends;
    for (std::size_t i = 1; i < solved.results.history.size(); ++i)
        if (solved.results.history[i].stage != solved.results.history[i - 1].stage)
            ends.push_back(solved.results.history[i - 1].values[1]);
    ASSERT_EQ(ends.size(), 2u);
    EXPECT_NEAR(ends[1], 1e3 + 5e3 * tanPhi, 1e-6 * 3e3);
    // Pressed more, the anchor sticks.
    EXPECT_LT(reading(solved, "last joint force"), 1e3 + 8e3 * tanPhi);
    EXPECT_EQ(eventsOf(solved, EventKind::Restick).size(), 1u);
    Scene again = solved.scene;
    again.stages.push_back(pullStage(again, 4e-3, 40));
    again.stages.back().name = "pull again";
    EXPECT_NEAR(reading(solve(again), "last joint force"), 1e3 + 8e3 * tanPhi, 1e-6 * 3e3);
}

TEST(BoltLaws, FrictionAloneIsUnchangedByAnAngleOfZero) {
    const Solved solved = solve(clampedHead(AnchorLaw::Frictional, 3e3, 0.0, 0.0));
    EXPECT_NEAR(reading(solved, "max joint force"), 3e3, 1e-3);
    EXPECT_NEAR(reading(solved, "last joint force"), 3e3, 1e-3);
}

/// Two blocks that a bolt clamps together; soft joint, so that the bolt's share of a load shows.
struct Clamped {
    double pretension = 1e3, load = 600.0, anchor = 1e9, plate = 1e9;
    Scene scene;

    Clamped() : scene(twoBlocks(rigidRock, 1.0, 2.0)) {
        scene.analysis.penaltyRatio = 1e-6;
        scene.jointMaterials[0].second.frictionAngle = 30.0;
        BoltType type = linearType(barArea(), 200e9);
        type.anchors = {anchorAt(0.0, AnchorLaw::Elastic, anchor)};
        type.plate.normalStiffness = plate;
        addBolt(scene, type, 0.2, 2.0, 18, PlateKind::Spring);
        scene.bolts[0].pretension = pretension;
        Stage install;
        install.name = "install";
        scene.stages = {install, loadStage(scene, load, 4)};
    }
    double boltStiffness() const { return 1.0 / (1.0 / anchor + 1.8 / (200e9 * barArea()) + 1.0 / plate); }
    double jointStiffness() const { return 2.0 * numericsOf(scene.analysis).penaltyRatio * rigidRock; }
};

// After installation the bolt has its pre-tension and the joint carries it; a load smaller than that is shared by the
// stiffnesses of bolt and joint.
TEST(BoltLaws, PretensionClampsTheJoint) {
    const Clamped clamped;
    const Solved solved = solve(clamped.scene);
    const Frame* installed = nullptr;
    for (const Frame& frame : solved.results.frames)
        if (frame.stage == 0) installed = &frame;
    ASSERT_TRUE(installed);
    const double t = clamped.pretension;
    for (const BoltNodeFrame& node : installed->bolts[0].nodes) EXPECT_NEAR(node.axialForce, t, 1e-6 * t) << node.s;
    double joint = 0.0;
    for (const ContactFrame& contact : installed->contacts) joint += contact.normalForce;
    EXPECT_NEAR(joint, t, 1e-6 * t);
    const double kb = clamped.boltStiffness(), kj = clamped.jointStiffness();
    const double share = clamped.load * kb / (kb + kj);
    EXPECT_NEAR(reading(solved, "last joint force"), t + share, 1e-3 * share);
    EXPECT_NEAR(reading(solved, "last B.plate_force"), t + share, 1e-3 * share);
    EXPECT_NEAR(reading(solved, "last opening"), -t / kj + clamped.load / (kb + kj), 1e-3 * t / kj);
    for (const StageResult& stage : solved.results.stages) EXPECT_LT(std::abs(stage.health.balanceError), 1e-3);
}

TEST(BoltLaws, PretensionOverThePlatesStrengthLosesIt) {
    Clamped clamped;
    clamped.scene.boltTypes[0].plate.normalStrength = 800.0;
    const Solved solved = solve(clamped.scene);
    EXPECT_EQ(countOf(solved, EventKind::PlateLoss), 1);
}

/// The block there starts at 1 m/s along the bolt.
Stage burst(const Point& blockAt) {
    Stage stage;
    stage.name = "burst";
    stage.kind = StageKind::Dynamic;
    stage.duration = 0.3;
    stage.timeStep = 5e-4;
    InitialVelocity start;
    start.blockAt = blockAt;
    start.velocity = {1.0, 0.0};
    stage.initialVelocities = {start};
    return stage;
}

// A block of mass m that flies at v is stopped by friction f over m·v²/2f; dynamic strength shortens the way.
TEST(BoltLaws, TheDynamicFactorScalesWhatAnAnchorHolds) {
    for (const double factor : {1.0, 1.5}) {
        Scene scene = gapBlocks(0.1);
        BoltType type = linearType(barArea(), 200e9);
        Anchor slipping = anchorAt(0.0, AnchorLaw::Frictional, 1e9);
        slipping.strength = friction;
        type.anchors = {slipping, anchorAt(0.5, AnchorLaw::Elastic, 1e9)};
        type.dynamicFactor = factor;
        addBolt(scene, type, 0.75, 1.25, 10, PlateKind::None);
        scene.stages = {burst(Point(1.6, 0.6))};
        const double way = 0.5 * 2700.0 * 1.0 / (factor * friction);
        EXPECT_NEAR(reading(solve(scene), "max opening"), way, 0.02 * way) << factor;
    }
}

/// A friction bolt embedded over 1.5 m, its plate under a slab of 1 m³ that flies off at 1 m/s, weight along the bolt.
Scene caughtSlab(double bondFactor) {
    Scene scene = twoBlocks(rigidRock, 2.0, 3.0);
    scene.analysis.tolerance = 1e-8;
    scene.analysis.gravity = {gravity, 0.0};
    BoltType tube = linearType(380e-6, 200e9);
    Anchor hole = anchorRange(Per::Length, AnchorLaw::Frictional, 750e6, 54e3, 0.0);
    hole.to = BoltPlace{false, 1.5};
    tube.anchors = {hole};
    tube.dynamicFactor = bondFactor;
    tube.plate.normalStrength = 60e3;
    addBolt(scene, tube, 0.5, 3.0, 100, PlateKind::Spring);
    scene.stages = {burst(Point(2.6, 0.6))};
    return scene;
}

/// (pL − mg)·s − ½ps² = ½mv²
double slidingWay(double perMetre) {
    const double mass = 2700.0, spare = 1.5 * perMetre - mass * gravity;
    return (spare - std::sqrt(spare * spare - perMetre * mass)) / perMetre;
}

TEST(BoltLaws, AFrictionBoltCatchesASlabWithItsDynamicBondAndItsWholePlate) {
    const Solved solved = solve(caughtSlab(0.5));
    const double way = slidingWay(27e3);
    EXPECT_NEAR(reading(solved, "max opening"), way, 0.02 * way);
    EXPECT_EQ(countOf(solved, EventKind::PlateLoss), 0);
}

TEST(BoltLaws, TheFactorsOfSteelAndPlateAreTheirOwn) {
    Scene plate = caughtSlab(0.5);
    plate.boltTypes[0].plateDynamicFactor = 0.5;  // 30 kN, less than the 40.5 kN at which the bond slides
    EXPECT_EQ(countOf(solve(plate), EventKind::PlateLoss), 1);
    Scene steel = caughtSlab(0.5);
    steel.boltTypes[0].youngsModulus.reset();
    steel.boltTypes[0].steel = {{0.0, 0.0}, {0.001, 200e6}, {0.01, 201e6}};  // 76 kN
    steel.boltTypes[0].bending = Bending::None;
    EXPECT_EQ(countOf(solve(steel), EventKind::Yield), 0);
    steel.boltTypes[0].steelDynamicFactor = 0.5;  // 38 kN
    EXPECT_GT(countOf(solve(steel), EventKind::Yield), 0);
}

TEST(BoltLaws, ABoltsOwnFactorsStandInPlaceOfItsTypes) {
    Scene scene = caughtSlab(1.0);
    scene.bolts[0].dynamicFactor = 0.5;
    const double way = slidingWay(27e3);
    EXPECT_NEAR(reading(solve(scene), "max opening"), way, 0.02 * way);
    scene.bolts[0].plateDynamicFactor = 0.5;
    EXPECT_EQ(countOf(solve(scene), EventKind::PlateLoss), 1);
}

// Friction p per metre over what is left in the hole, until nothing is: force p·(embedded length), then none.
TEST(BoltLaws, ABoltCanBePulledRightOut) {
    const double perMetre = 50e3, embedded = 0.105;
    Scene scene = gapBlocks(0.1);
    BoltType type = linearType(380e-6, 200e9);
    Anchor tube = anchorRange(Per::Length, AnchorLaw::Frictional, 5e9, perMetre, 0.0);
    tube.to = BoltPlace{false, 0.2};
    type.anchors = {tube, anchorAt(0.4, AnchorLaw::Elastic, 1e9)};
    addBolt(scene, type, 1.0 - embedded, 1.4 - embedded, 80, PlateKind::None);
    scene.monitors.back().at = 0.25;
    scene.stages = {pullStage(scene, 0.14, 70)};
    const Solved solved = solve(scene);
    const Frame& first = solved.results.frames.front();
    double holds = 0.0;
    for (const BoltNodeFrame& node : first.bolts[0].nodes) holds += node.bondStrength;
    EXPECT_EQ(first.time, 0.0);
    EXPECT_NEAR(holds, perMetre * embedded, 1e-6 * perMetre * embedded);  // half as much at either end
    for (const auto& [opening, force] : loadPath(solved))
        if (opening > 2e-3 && opening < embedded - 6e-3) {
            EXPECT_NEAR(force, perMetre * (embedded - opening), 0.01 * perMetre * embedded) << opening;
        }
    const std::vector<Event> out = eventsOf(solved, EventKind::PulledOut);
    ASSERT_EQ(out.size(), 1u);
    EXPECT_EQ(out[0].bolt, 0);
    EXPECT_EQ(out[0].block, 0);
    EXPECT_NEAR(reading(solved, "last joint force"), 0.0, 1e-3);
}

// What bolts took adds up to what the run booked.
TEST(BoltLaws, EnergiesOfBoltsAddUp) {
    const Solved solved = solve(paperRebar(200e9, 24.56e3, 59, rigidRock, 5e-3, 50));
    const Frame& last = solved.results.frames.back();
    const double released = last.energy.friction + last.energy.released;
    EXPECT_NEAR(last.bolts[0].elasticEnergy, last.energy.bolt, 1e-12 * last.energy.bolt);
    EXPECT_NEAR(last.bolts[0].bondEnergy, released, 1e-9 * released);
    EXPECT_EQ(last.bolts[0].plasticEnergy, 0.0);
}

// While the load rises each release waits for it; once the peak is passed one brings the next, to the end of the bond.
TEST(BoltLaws, EachReleaseKnowsWhatSetItOver) {
    const Solved solved = solve(paperRebar(200e9, 24.56e3, 59, rigidRock, 5e-3, 50));
    const std::vector<Event>& events = solved.results.events;
    const std::vector<Event> bonds = eventsOf(solved, EventKind::Debonding);
    ASSERT_EQ(bonds.size(), 51u);
    for (const Event& bond : bonds) {
        if (bond.node >= 7) {
            EXPECT_EQ(bond.cause, -1) << bond.node;
            continue;
        }
        ASSERT_GE(bond.cause, 0) << bond.node;
        const Event& cause = events[bond.cause];
        EXPECT_EQ(cause.time, bond.time);
        EXPECT_GT(cause.node, bond.node);
        EXPECT_LE(cause.node, 7);
    }
}

}  // namespace
}  // namespace keyblock
