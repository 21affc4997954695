// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Glue holds cells together whatever the block does as a whole: a moved and
// turned block carries no force, a spinning one keeps its momentum, and cells
// meet others as one block does.
#include "solver/engine/contact/search.h"
#include "solver/engine/glue.h"
#include "solver/engine/model/edge.h"
#include "solver/engine/setup/make_model.h"
#include "solver/engine/stage/energy.h"

#include "solver/engine/bolt/topology.h"
#include "solver/engine/stage/dynamics.h"
#include "solver/engine/step/step_forces.h"
#include "solver/verify/scenes.h"
#include "tests/solver/engine/silent_observer.h"

#include <gtest/gtest.h>

#include <cmath>

namespace keyblock {
namespace {

Block cut(Block block, double size) {
    block.subBlocks = CellSettings{size};
    return block;
}

/// One block of 1 m × 1 m in 16 cells.
Scene square(double modulus) {
    Scene scene = emptyScene(modulus, 0.25, 30.0);
    scene.blocks = {cut(boxBlock("block", {0, 0}, {1, 1}), 0.25)};
    return scene;
}

StepProblem glueOnly(const Model& model, const State& state) {
    StepProblem problem;
    problem.blocks = static_cast<int>(model.blocks.size());
    addGlueLinks(model, state, problem);
    return problem;
}

/// Spin of the whole about the origin [kg m²/s].
double angularMomentum(const Model& model, const State& state) {
    double sum = 0.0;
    for (std::size_t i = 0; i < model.blocks.size(); ++i) {
        const BlockMotion& motion = state.blocks[i];
        sum += model.blocks[i].mass * cross(motion.centroid, centroidVelocity(motion)) +
               (model.blocks[i].massMatrix * motion.velocity)[2];
    }
    return sum;
}

void turnWhole(State& state, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    for (BlockMotion& motion : state.blocks) {
        const Point p = motion.centroid;
        motion.centroid = Point(c * p.x() - s * p.y(), s * p.x() + c * p.y());
        motion.angle = angle;
    }
}

TEST(Glue, JoinsEveryPairOfCellsThatShareAnEdge) {
    const Model model = makeModel(square(10e9));
    EXPECT_EQ(model.blocks.size(), 16u);
    EXPECT_EQ(model.glue.size(), 24u);
    EXPECT_EQ(model.blocks[4].name, "block:5");
    const State state = makeState(model);
    EXPECT_TRUE(findContacts(model, state.blocks, {}, 0.1, true).empty());
}

TEST(Glue, CostsNothingWhereNoBlockIsCut) {
    Scene scene = square(10e9);
    scene.blocks[0].subBlocks.reset();
    const Model model = makeModel(scene);
    EXPECT_EQ(model.blocks.size(), 1u);
    EXPECT_TRUE(model.glue.empty());
    EXPECT_TRUE(makeState(model).glue.empty());
    EXPECT_TRUE(model.blocks[0].inner.empty());
}

TEST(Glue, IsWithoutForceInABlockThatMovedAndTurnedAsAWhole) {
    const Model model = makeModel(square(10e9));
    State state = makeState(model);
    turnWhole(state, 2.0);
    for (BlockMotion& motion : state.blocks) motion.centroid += Point(3.0, -1.0);
    for (const Link& link : glueOnly(model, state).links) EXPECT_NEAR(link.strain, 0.0, 1e-14);
}

TEST(Glue, StrainsGrowAsTheirDerivativesSay) {
    const Model model = makeModel(square(10e9));
    State state = makeState(model);
    Vector6 first, second;
    first << 1e-5, -2e-5, 1e-5, 1e-4, 2e-4, -1e-4;
    second << 2e-5, 1e-5, -1e-5, -1e-4, 1e-4, 2e-4;
    turnWhole(state, 0.3);
    moveBlock(model.blocks[0], state.blocks[0], first);
    moveBlock(model.blocks[1], state.blocks[1], second);
    const StepProblem problem = glueOnly(model, state);
    const double tiny = 1e-7;
    for (int unknown = 0; unknown < 12; ++unknown) {
        Eigen::VectorXd d = Eigen::VectorXd::Zero(problem.unknowns());
        d[unknown] = tiny;
        State moved = state;
        for (const int block : {0, 1}) moveBlock(model.blocks[block], moved.blocks[block], d.segment<6>(6 * block));
        std::vector<double> predicted;
        linkStrains(problem, d, predicted);
        const StepProblem after = glueOnly(model, moved);
        for (std::size_t i = 0; i < predicted.size(); ++i)
            EXPECT_NEAR((after.links[i].strain - problem.links[i].strain) / tiny,
                        (predicted[i] - problem.links[i].strain) / tiny, 1e-3)
                << "unknown " << unknown << ", link " << i;
    }
}

TEST(Glue, KeepsTheAngularMomentumOfASpinningBlock) {
    const Model model = makeModel(square(60e9));
    State state = makeState(model);
    Point middle(0.5, 0.5);
    for (BlockMotion& motion : state.blocks) {
        const Point v = Point(0.2, -0.1) + turnLeft(Point(motion.centroid - middle));
        motion.velocity << v.x(), v.y(), 1.0, 0.0, 0.0, 0.0;
    }
    Engine engine(model);
    const Loads loads;
    DynamicStage stage(engine, loads, [](double) { return LoadPoint{}; }, {Inertia::Shi, 0.01});
    const double start = angularMomentum(model, state);
    double time = 0.0, worst = 0.0;
    test::SilentObserver silent;
    DynamicPace pace;
    for (int step = 0; step < 1000; ++step) {
        ASSERT_EQ(stage.step(state, time, 10.0, pace, silent).ending, Ending::Done);
        worst = std::max(worst, std::abs(angularMomentum(model, state) / start - 1.0));
    }
    EXPECT_LT(worst, 1e-9);
    EXPECT_NEAR(state.blocks[0].angle, 10.0, 10.0 * 0.01 * 0.01 / 12.0 * 1.01);  // a chord for an arc in each step
    double area = 0.0;
    for (const BlockModel& block : model.blocks) area += block.area;
    EXPECT_NEAR(area, 1.0, 1e-12);
    EXPECT_NEAR((state.blocks[15].centroid - state.blocks[0].centroid).norm(), 0.75 * std::sqrt(2.0), 1e-5);
}

TEST(Cells, OfAFixedBlockAreAllFixed) {
    Scene scene = square(10e9);
    Support support;
    support.blockAt = Point(0.4, 0.4);
    scene.supports = {support};
    const Model model = makeModel(scene);
    for (const BlockModel& block : model.blocks) EXPECT_TRUE(block.fixed);
}

TEST(Cells, MeetAnotherBlockByTheirFacesOnly) {
    Scene scene = square(10e9);
    scene.blocks.push_back(boxBlock("top", {0.2, 1.0}, {0.8, 1.5}));
    const Model model = makeModel(scene);
    const State state = makeState(model);
    for (const Contact& c : findContacts(model, state.blocks, {}, 0.01, true)) {
        EXPECT_TRUE(c.blockA == 16 || c.blockB == 16);
        EXPECT_NEAR(std::abs(edgeOf(state.blocks[c.blockB].corners, c.edge).outward.y()), 1.0, 1e-9);
    }
}

/// A bolt from 0.1 to 1.9 m through two blocks that meet at 1 m; the left one in cells.
Scene boltedCells(double height) {
    Scene scene = emptyScene(10e9, 0.2, 30.0);
    scene.blocks = {cut(boxBlock("left", {0, 0}, {1, 1}), 0.25), boxBlock("right", {1, 0}, {2, 1})};
    BoltType type = linearType(barArea(), 200e9);
    type.anchors = {anchorRange(Per::Length, AnchorLaw::Frictional, 1e9, 1e4, 0.0)};
    type.normalPer = Per::Length;
    addBolt(scene, type, 0.1, 1.9, 18, PlateKind::None);
    scene.bolts[0].farEnd.y() = scene.bolts[0].head.y() = height;
    return scene;
}

TEST(Cells, AreOneRockToABolt) {
    for (const double height : {0.6, 0.5}) {  // through cells, and along the edge between two rows
        const Model model = makeModel(boltedCells(height));
        ASSERT_EQ(model.bolts[0].joints.size(), 1u) << height;
        EXPECT_NEAR(model.bolts[0].joints[0], 0.9, 1e-9);
        State state = makeState(model);
        placeBolts(model, state);
        double embedded[2] = {0.0, 0.0};
        for (std::size_t n = 0; n < state.bolts[0].nodes.size(); ++n) {
            const BoltNode& node = state.bolts[0].nodes[n];
            const double x = model.bolts[0].s[n] + 0.1;
            if (std::abs(x - 1.0) < 1e-6) continue;
            ASSERT_GE(node.slot, 0) << "node " << n;
            const BlockModel& block = model.blocks[state.bolts[0].slots[node.slot].block];
            EXPECT_EQ(block.rock, x < 1.0 ? 0 : 1);
            embedded[block.rock] += node.bond.share;
        }
        EXPECT_NEAR(embedded[0], 0.9, 1e-6) << height;
        EXPECT_NEAR(embedded[1], 0.9, 1e-6) << height;
        EXPECT_LT(followBolts(model, state), 1e-6);
    }
}

}  // namespace
}  // namespace keyblock
