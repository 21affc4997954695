// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What one stage leaves to the next, what a stage changes, and where a run ends.
#include "solver/run/run.h"

#include "solver/engine/setup/make_model.h"
#include "solver/run/stage_loads.h"
#include "solver/verify/readings.h"
#include "solver/verify/scenes.h"
#include "tests/solver/run/small_stages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace keyblock {
namespace {

using test::lastOf;

Stage stageNamed(const std::string& name, StageKind kind, double duration = 0.0) {
    Stage stage;
    stage.name = name;
    stage.kind = kind;
    stage.duration = duration;
    if (kind == StageKind::Dynamic) stage.timeStep = 1e-3;
    return stage;
}

StrengthChange changed(std::optional<double> frictionAngle, std::optional<double> cohesion,
                       std::optional<double> tensileStrength = std::nullopt) {
    return {"joint", frictionAngle, cohesion, tensileStrength};
}

/// A block on a slope that settles under its weight and then goes through the given stages.
Solved onSlope(double slope, const JointMaterial& joint, std::vector<Stage> stages) {
    Scene scene = inclineScene(slope, joint.frictionAngle, 1.0);
    scene.jointMaterials[0].second = joint;
    stages.insert(stages.begin(), stageNamed("settle", StageKind::Static));
    scene.stages = std::move(stages);
    return solve(scene);
}

double slideOf(double slope, double friction, double time) {
    const double a = slope * degree;
    return 0.5 * gravity * (std::sin(a) - std::cos(a) * std::tan(friction * degree)) * time * time;
}

long slipsOfStage(const Solved& solved, int stage) {
    return std::count_if(solved.results.events.begin(), solved.results.events.end(), [&](const Event& event) {
        return event.stage == stage && event.kind == EventKind::JointSlip;
    });
}

TEST(Set, WeakenedFrictionLetsABlockSlide) {
    Stage weaken = stageNamed("weaken", StageKind::Dynamic, 1.0);
    weaken.set = {changed(20.0, std::nullopt)};
    weaken.zeroDisplacements = true;
    const Solved solved = onSlope(30.0, {35.0, 0.0, 0.0}, {weaken});
    EXPECT_EQ(solved.results.stages[0].outcome, Outcome::Equilibrium);
    const double expected = slideOf(30.0, 20.0, 1.0);
    EXPECT_NEAR(slidDown(solved, 30.0), expected, 1e-3 * expected);
    EXPECT_EQ(slipsOfStage(solved, 1), 1);
    EXPECT_LT(std::abs(solved.results.stages[1].health.balanceError), 1e-3);
}

/// A corner bears up to 0.81 of its normal force, as the block would tip; tan 58° is enough, and nothing at all moves.
TEST(Set, StrengthThatIsNotNeededMovesNothing) {
    Stage weaken = stageNamed("weaken", StageKind::Static);
    weaken.set = {changed(58.0, 0.0, 0.0)};
    for (const JointMaterial& joint : {JointMaterial{60.0, 0.0, 0.0}, JointMaterial{60.0, 1e5, 1e4}}) {
        const Solved solved = onSlope(30.0, joint, {weaken});
        EXPECT_TRUE(solved.results.events.empty());
        const BlockState &before = lastOf(solved, 0).blocks[1], &after = lastOf(solved, 1).blocks[1];
        EXPECT_LT((after.displacement - before.displacement).norm(), 1e-14);  // round-off
        EXPECT_NEAR(after.stress[1], before.stress[1], 1e-6 * std::abs(before.stress[1]));
        for (const ContactFrame& contact : lastOf(solved, 1).contacts) EXPECT_EQ(contact.state, ContactState::Locked);
    }
}

/// Cohesion that is taken away lets go corner by corner, each with its event and equilibrium between; what friction
/// cannot hold then slides away.
TEST(Set, TakenCohesionLetsGoAndCollapses) {
    Stage weaken = stageNamed("weaken", StageKind::Static);
    weaken.set = {changed(20.0, 0.0, 0.0)};
    Stage after = stageNamed("after", StageKind::Static);
    for (const bool goesOn : {true, false}) {
        weaken.continueAfterCollapse = goesOn;
        const Solved solved = onSlope(30.0, {20.0, 1e5, 1e4}, {weaken, after});
        ASSERT_GE(solved.results.stages.size(), 2u);
        EXPECT_EQ(solved.results.stages[0].outcome, Outcome::Equilibrium);
        EXPECT_EQ(solved.results.stages[1].outcome, Outcome::Collapse);
        EXPECT_EQ(solved.results.stages[1].blocks, std::vector<int>{1});
        EXPECT_EQ(solved.results.stages.size(), goesOn ? 3u : 2u);
        EXPECT_EQ(slipsOfStage(solved, 1), 2);  // both corners
    }
}

/// Half of the strength that is needed: the block that hung by tension falls.
TEST(Set, TakenTensionLetsAHangingBlockFall) {
    Scene scene = emptyScene(60e9, 0.25, 30.0);
    scene.analysis.gravity = {0.0, -gravity};
    scene.jointMaterials[0].second = {30.0, 1e6, 1e6};
    scene.blocks = {boxBlock("roof", {0, 1}, {1, 2}), boxBlock("hanging", {0, 0}, {1, 1})};
    Support support;
    support.blockAt = Point(0.5, 1.5);
    scene.supports = {support};
    const double needed = 2700.0 * gravity;  // [Pa] over 1 m × 1 m
    Stage enough = stageNamed("enough", StageKind::Static), less = stageNamed("less", StageKind::Static);
    enough.set = {changed(std::nullopt, std::nullopt, 1.01 * needed)};
    less.set = {changed(std::nullopt, std::nullopt, 0.99 * needed)};
    scene.stages = {stageNamed("hang", StageKind::Static), enough, less};
    const Solved solved = solve(scene);
    ASSERT_EQ(solved.results.stages.size(), 3u);
    EXPECT_EQ(solved.results.stages[1].outcome, Outcome::Equilibrium);
    EXPECT_EQ(solved.results.stages[2].outcome, Outcome::Collapse);
    ASSERT_FALSE(solved.results.events.empty());
    EXPECT_EQ(solved.results.events.front().stage, 2);
    EXPECT_EQ(solved.results.events.front().kind, EventKind::JointOpen);
    EXPECT_NEAR(solved.results.events.front().axialForce, 0.5 * needed, 1e-3 * needed);  // one of two corners
}

/// Grout: a joint without cohesion is given some while the block stands, then loses its friction.
TEST(Set, GivenCohesionHolds) {
    Stage grout = stageNamed("grout", StageKind::Static), weaken = stageNamed("weaken", StageKind::Static);
    grout.set = {changed(std::nullopt, 1e5, 1e4)};
    weaken.set = {changed(5.0, std::nullopt)};
    const Solved held = onSlope(30.0, {35.0, 0.0, 0.0}, {grout, weaken});
    for (const StageResult& stage : held.results.stages) EXPECT_EQ(stage.outcome, Outcome::Equilibrium);
    EXPECT_LT((lastOf(held, 2).blocks[1].displacement - lastOf(held, 0).blocks[1].displacement).norm(), 1e-12);
    const Solved slid = onSlope(30.0, {35.0, 0.0, 0.0}, {weaken});
    EXPECT_EQ(slid.results.stages.back().outcome, Outcome::Collapse);
}

/// Cohesion once lost does not come back.
TEST(Set, LostCohesionStaysLost) {
    Stage weaken = stageNamed("weaken", StageKind::Dynamic, 0.2), stronger = stageNamed("stronger", StageKind::Dynamic, 0.2);
    weaken.set = {changed(20.0, 0.0, 0.0)};
    stronger.set = {changed(20.0, 1e9, 1e9)};
    const Solved solved = onSlope(30.0, {20.0, 1e5, 1e4}, {weaken, stronger});
    EXPECT_NEAR(slidDown(solved, 30.0), slideOf(30.0, 20.0, 0.4), 2e-3 * slideOf(30.0, 20.0, 0.4));
}

/// On 30° a peak of 35° holds. A stage that gives a residual angle of 20° changes nothing until a nudge makes the block
/// slip; a later one takes what slipped down to 10° at once.
TEST(Set, ResidualFrictionIsReachedAtTheFirstSlip) {
    constexpr double time = 0.4;  // [s] of each stage
    const auto residual = [](const std::string& name, double angle) {
        Stage stage = stageNamed(name, StageKind::Dynamic, time);
        StrengthChange to = changed(std::nullopt, std::nullopt);
        to.residualFrictionAngle = angle;
        stage.set = {to};
        return stage;
    };
    Stage first = residual("first", 20.0);
    EXPECT_LT(slidDown(onSlope(30.0, {35.0, 0.0, 0.0}, {first}), 30.0), 1e-6);
    first.zeroDisplacements = true;
    InitialVelocity nudge;
    const double c = std::cos(30.0 * degree), s = std::sin(30.0 * degree), v = 0.1;
    nudge.blockAt = {c * 1.5 + s * 0.25, -s * 1.5 + c * 0.25};
    nudge.velocity = {c * v, -s * v};
    first.initialVelocities = {nudge};
    const Solved solved = onSlope(30.0, {35.0, 0.0, 0.0}, {first, residual("second", 10.0)});
    const double reached = v + 2.0 * slideOf(30.0, 20.0, time) / time;
    const double expected = v * time + slideOf(30.0, 20.0, time) + reached * time + slideOf(30.0, 10.0, time);
    EXPECT_NEAR(slidDown(solved, 30.0), expected, 3e-3 * expected);
    for (const StageResult& stage : solved.results.stages) EXPECT_LT(std::abs(stage.health.balanceError), 1e-2);
}

/// The weaker of two materials governs a joint, before and after a change.
TEST(Set, TheWeakerMaterialGovernsAnew) {
    Scene scene = inclineScene(30.0, 35.0, 1.0);
    scene.jointMaterials.push_back({"other", {40.0, 0.0, 0.0}});
    scene.blocks[1].jointMaterial = "other";
    Stage weaken = stageNamed("weaken", StageKind::Dynamic, 1.0);
    weaken.set = {{"other", 20.0, std::nullopt, std::nullopt}};
    weaken.zeroDisplacements = true;
    scene.stages = {stageNamed("settle", StageKind::Static), weaken};
    const Solved solved = solve(scene);
    EXPECT_NEAR(slidDown(solved, 30.0), slideOf(30.0, 20.0, 1.0), 1e-3 * slideOf(30.0, 20.0, 1.0));
}

/// A block on a floor without gravity: the floor bears what the loads of all stages so far press.
struct Pressed {
    Scene scene = emptyScene(60e9, 0.25, 30.0);

    Pressed() {
        scene.blocks = {boxBlock("floor", {0, 0}, {1, 1}), boxBlock("block", {0, 1}, {1, 2})};
        Support support;
        support.blockAt = Point(0.5, 0.5);
        scene.supports = {support};
    }
    void stage(const std::string& name, const std::vector<Load>& loads) {
        scene.stages.push_back(stageNamed(name, StageKind::Static));
        scene.stages.back().loads = loads;
    }
    /// Summed contact force at the end of every stage [N].
    std::vector<double> borne() const {
        const Solved solved = solve(scene);
        std::vector<double> sums;
        for (int i = 0; i < static_cast<int>(solved.results.stages.size()); ++i) {
            EXPECT_EQ(solved.results.stages[i].outcome, Outcome::Equilibrium);
            double sum = 0.0;
            for (const ContactFrame& contact : lastOf(solved, i).contacts) sum += contact.normalForce;
            sums.push_back(sum);
        }
        return sums;
    }
};

Load down(double force) {
    Load load;
    load.blockAt = Point(0.4, 1.6);
    load.force = {0.0, -force};
    return load;
}

Load downAtPoint(double force) {
    Load load;
    load.point = Point(0.5, 2.0);
    load.force = {0.0, -force};
    return load;
}

Load pressing(double pressure) {
    Load load;
    load.along = {Point(0.0, 2.0), Point(1.0, 2.0)};
    load.pressure = pressure;
    return load;
}

void expectBorne(const Pressed& pressed, const std::vector<double>& expected) {
    const std::vector<double> borne = pressed.borne();
    ASSERT_EQ(borne.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(borne[i], expected[i], 1e-6 * expected[i]) << i;
}

TEST(Loads, StayUntilALaterStagePutsAnotherInTheirPlace) {
    Pressed pressed;
    pressed.stage("first", {down(1e5), pressing(1e4)});
    pressed.stage("nothing new", {});
    Load elsewhereInTheBlock = down(3e5);
    elsewhereInTheBlock.blockAt = Point(0.9, 1.1);
    pressed.stage("more", {elsewhereInTheBlock});
    pressed.stage("at a point", {downAtPoint(5e4), downAtPoint(5e4)});
    pressed.stage("less pressure", {pressing(5e3)});
    pressed.stage("less at the point", {downAtPoint(2e4)});
    expectBorne(pressed, {1.1e5, 1.1e5, 3.1e5, 4.1e5, 4.05e5, 3.25e5});
}

/// The replaced load fades as the new one comes, so a cohesive joint that bears both never sees none.
TEST(Loads, AreReplacedWithoutAGap) {
    Pressed pressed;
    pressed.scene.jointMaterials[0].second = {30.0, 2e5, 1e5};
    pressed.stage("lift", {down(-8e4)});
    pressed.stage("lift less", {down(-7e4)});
    const Solved solved = solve(pressed.scene);
    EXPECT_TRUE(solved.results.events.empty());
    EXPECT_EQ(solved.results.stages[1].outcome, Outcome::Equilibrium);
}

/// What later stages have replaced is dropped once it has faded out, so that a stage costs the same however many came
/// before it.
TEST(Loads, ReplacedOnesAreNotKept) {
    Pressed pressed;
    for (int i = 0; i < 20; ++i) pressed.stage("stage " + std::to_string(i), {down(1e4 * (1 + i % 3)), pressing(1e3)});
    const Model model = makeModel(pressed.scene);
    State state = makeState(model);
    LoadMemory memory;
    StageLoads loads(model, pressed.scene, memory);
    for (int i = 0; i < 20; ++i) {
        loads.begin(i, state);
        EXPECT_LE(memory.loads.forces.size(), 2u) << i;
        EXPECT_LE(memory.loads.pressures.size(), 2u) << i;
        loads.end(loads.at(1.0));
    }
}

/// Least opening in a stage; 0 where none is less.
double leastOpening(const Solved& solved, int stage) {
    double least = 0.0;
    for (const HistoryRow& row : solved.results.history)
        least = row.stage == stage ? std::min(least, row.values[0]) : least;
    return least;
}

TEST(ZeroDisplacements, CountBlocksMonitorsAndMotionsAnew) {
    Scene scene = twoBlocks(60e9, 1.0, 2.0);
    scene.stages = {pullStage(scene, 1e-3, 10), pullStage(scene, 2e-3, 10), pullStage(scene, 0.5e-3, 10)};
    scene.stages[1].name = "further";
    scene.stages[2].name = "back";
    scene.stages[1].zeroDisplacements = true;
    const Solved solved = solve(scene);
    const double start = 1.5;
    EXPECT_NEAR(lastOf(solved, 0).blocks[1].displacement.x(), 1e-3, 1e-12);
    EXPECT_NEAR(lastOf(solved, 1).blocks[1].displacement.x(), 2e-3, 1e-12);
    EXPECT_NEAR(lastOf(solved, 1).blocks[1].centroid.x(), start + 3e-3, 1e-12);
    EXPECT_NEAR(lastOf(solved, 2).blocks[1].centroid.x(), start + 1.5e-3, 1e-12);
    EXPECT_NEAR(reading(solved, "last opening"), 0.5e-3, 1e-12);
    const double least = leastOpening(solved, 1);
    EXPECT_GE(least, -1e-12);  // nothing is pulled back to where it came from
}

Scene slidingBlock() {
    Scene scene = inclineScene(30.0, 20.0, 0.2);
    scene.output.every = 0.01;
    return scene;
}

/// A limit ends a run; it changes nothing of what came before.
TEST(Limits, StepsEndARunAtOnce) {
    const Results whole = runInMemory(slidingBlock());
    Scene scene = slidingBlock();
    scene.limits.steps = 73;
    const Results cut = runInMemory(scene);
    ASSERT_EQ(cut.stages.size(), 1u);
    EXPECT_EQ(cut.stages[0].outcome, Outcome::Limit);
    EXPECT_EQ(cut.stages[0].steps, 73);
    EXPECT_NE(cut.stages[0].message.find("73 steps"), std::string::npos);
    ASSERT_GE(cut.frames.size(), 8u);
    for (std::size_t i = 0; i + 1 < cut.frames.size(); ++i) EXPECT_TRUE(cut.frames[i] == whole.frames[i]) << i;
    EXPECT_EQ(cut.frames.back().step, 73);
}

TEST(Limits, CountStepsOverAllStages) {
    Scene scene = slidingBlock();
    scene.stages.push_back(scene.stages[0]);
    scene.stages[1].name = "on";
    scene.limits.steps = 250;
    const Results results = runInMemory(scene);
    ASSERT_EQ(results.stages.size(), 2u);
    EXPECT_EQ(results.stages[0].outcome, Outcome::Duration);
    EXPECT_EQ(results.stages[1].outcome, Outcome::Limit);
    EXPECT_EQ(results.stages[1].steps, 50);
    scene.limits.steps = 400;  // just enough
    EXPECT_EQ(runInMemory(scene).stages[1].outcome, Outcome::Duration);
    scene.limits.steps = 200;  // the second stage is not even begun upon
    EXPECT_EQ(runInMemory(scene).stages.back().outcome, Outcome::Limit);
    EXPECT_EQ(runInMemory(scene).stages.back().steps, 0);
}

TEST(Limits, HoldInStaticStages) {
    Scene scene = twoBlocks(60e9, 1.0, 2.0);
    scene.stages = {pullStage(scene, 1e-3, 50)};
    scene.limits.steps = 20;
    const Results results = runInMemory(scene);
    EXPECT_EQ(results.stages[0].outcome, Outcome::Limit);
    EXPECT_EQ(results.stages[0].steps, 20);
    EXPECT_GT(results.stages[0].time, 0.0);
    EXPECT_LT(results.stages[0].time, 1.0);
}

TEST(Limits, TheClockEndsARunThatIsTooLong) {
    const Results whole = runInMemory(slidingBlock());
    Scene scene = slidingBlock();
    scene.stages[0].duration = 1e4;
    scene.limits.wallTime = 0.3;
    const Results cut = runInMemory(scene);
    EXPECT_EQ(cut.stages[0].outcome, Outcome::Limit);
    EXPECT_NE(cut.stages[0].message.find("0.3 s"), std::string::npos);
    ASSERT_FALSE(cut.frames.empty());
    for (std::size_t i = 0; i + 1 < std::min(cut.frames.size(), whole.frames.size()); ++i)
        EXPECT_TRUE(cut.frames[i] == whole.frames[i]) << i;
}

/// A block is pushed along its base until 0.65 m of 1.0 m are left, then grouted and lifted: each corner stands for half
/// of what is left, and the first tears off at 0.1 MPa on it.
TEST(Set, GroutHoldsWhereFacesMeetNow) {
    Scene scene = emptyScene(10e9, 0.2, 0.0);
    scene.analysis.gravity = {0.0, -gravity};
    scene.blocks = {boxBlock("base", {0, -1}, {2, 0}), boxBlock("block", {0.9, 0}, {1.9, 1})};
    Support support;
    support.blockAt = Point(1.0, -0.5);
    scene.supports = {support};
    Stage push = stageNamed("push", StageKind::Static), lift = stageNamed("lift", StageKind::Static);
    push.increments = 10;
    push.motions = {{{1.4, 0.5}, {1.0, 0.0}, {{0.0, 0.0}, {1.0, 0.45}}, Rotation::Held}};
    lift.set = {changed(std::nullopt, 1e5, 1e5)};
    lift.increments = 10;
    Load load;
    load.blockAt = Point(1.4, 0.5);
    load.force = {0.0, 2e5};
    load.table = {{0.0, 0.0}, {1.0, 1.0}};
    lift.loads = {load};
    scene.stages = {stageNamed("settle", StageKind::Static), push, lift};
    const Solved solved = solve(scene);
    const auto opens = std::find_if(solved.results.events.begin(), solved.results.events.end(),
                                    [](const Event& event) { return event.kind == EventKind::JointOpen; });
    ASSERT_NE(opens, solved.results.events.end());
    EXPECT_NEAR(opens->axialForce, 0.5 * 0.65 * 1e5, 1.0);
}

/// Rock is grouted, not the plates that lie on it.
TEST(Set, GroutBondsNoPlate) {
    Scene scene = elasticRebar(20e6, rigidRock);
    scene.bolts[0].plate = PlateKind::Block;
    scene.stages[0].increments = 1;
    Stage grout = stageNamed("grout", StageKind::Static);
    grout.set = {changed(std::nullopt, 1e5, 1e5)};
    scene.stages.push_back(grout);
    const Solved solved = solve(scene);
    int onPlate = 0;
    for (const ContactFrame& contact : lastOf(solved, 1).contacts) {
        if (std::max(contact.blockA, contact.blockB) < 2) continue;
        EXPECT_NE(contact.state, ContactState::Bonded);
        ++onPlate;
    }
    EXPECT_EQ(onPlate, 2);
}

/// The lower the unbalanced force must be, the better the forces of a compressed column are; a stage that may take no
/// pseudo-step finds nothing.
TEST(Until, DecidesWhatCountsAsEquilibrium) {
    Scene scene = emptyScene(6e9, 0.25, 30.0);  // in stiffer rock round-off alone leaves more than 1e-8
    scene.analysis.tolerance = 1e-6;
    scene.analysis.gravity = {0.0, -gravity};
    scene.blocks = {boxBlock("floor", {0, 0}, {1, 1})};
    for (int i = 1; i < 6; ++i)
        scene.blocks.push_back(boxBlock("b" + std::to_string(i), {0.02 * i, i}, {1 + 0.02 * i, i + 1}));
    Support support;
    support.blockAt = Point(0.5, 0.5);
    scene.supports = {support};
    scene.stages = {stageNamed("stand", StageKind::Static)};
    for (const double unbalanced : {1e-2, 1e-5, 1e-8}) {
        scene.stages[0].until.unbalanced = unbalanced;
        const Results results = runInMemory(scene);
        EXPECT_EQ(results.stages[0].outcome, Outcome::Equilibrium);
        EXPECT_LE(results.stages[0].health.maxResidual, unbalanced);
    }
    scene.stages[0].until.maxSteps = 1;
    EXPECT_EQ(runInMemory(scene).stages[0].outcome, Outcome::Undecided);
}

}  // namespace
}  // namespace keyblock
