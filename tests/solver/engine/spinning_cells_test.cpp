// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A free block in cells that spins has constant energy and angular momentum under
// every scheme but backward Euler, whose loss is known in closed form.
#include "solver/engine/glue.h"
#include "solver/engine/setup/make_model.h"
#include "solver/engine/stage/dynamics.h"
#include "solver/engine/stage/energy.h"
#include "solver/engine/step/step_forces.h"
#include "solver/engine/time/mass.h"
#include "solver/verify/scenes.h"
#include "tests/solver/engine/silent_observer.h"

#include <gtest/gtest.h>

#include <cmath>

namespace keyblock {
namespace {

/// One block of 2 m × 1 m in 8 cells.
Scene slab() {
    Scene scene = emptyScene(50e9, 0.2, 30.0);
    scene.blocks = {boxBlock("block", {0, 0}, {2, 1})};
    scene.blocks[0].subBlocks = CellSettings{0.5};
    return scene;
}

struct Spin {
    double rate, timeStep, duration;  // [rad/s, s, s]
};

class SpinningCells {
public:
    explicit SpinningCells(double rate, const Point& velocity = {0.0, 0.0}) : state(makeState(model)) {
        for (BlockMotion& motion : state.blocks) {
            const Point v = velocity + rate * turnLeft(Point(motion.centroid - middle()));
            motion.velocity << v.x(), v.y(), rate, 0.0, 0.0, 0.0;
        }
        state.startEnergy = energy();
    }

    testing::AssertionResult run(const Spin& spin, Inertia scheme, const Damping& damping = {}) {
        DynamicStage stage(engine_, loads_, [](double) { return LoadPoint{}; },
                           {scheme, spin.timeStep, 0.8, damping});
        if (stage.begin(state).ending != Ending::Done) return testing::AssertionFailure() << "did not begin";
        DynamicPace pace;
        test::SilentObserver silent;
        for (double time = 0.0; time < spin.duration;)
            if (stage.step(state, time, spin.duration, pace, silent).ending != Ending::Done)
                return testing::AssertionFailure() << "failed at " << time << " s";
        return testing::AssertionSuccess();
    }

    double energy() const { return kineticEnergy(model, state) + storedEnergy(model, state).strain; }

    /// About the origin [kg m²/s].
    double angularMomentum() const {
        double sum = 0.0;
        for (std::size_t i = 0; i < model.blocks.size(); ++i) {
            const BlockMotion& motion = state.blocks[i];
            sum += model.blocks[i].mass * cross(motion.centroid, centroidVelocity(motion)) +
                   (model.blocks[i].massMatrix * motion.velocity)[2];
        }
        return sum;
    }

    /// Share of the kinetic energy of a pure spin that is in the motion of the cells' centroids.
    double centroidShare() const {
        double orbits = 0.0, own = 0.0;
        for (const BlockModel& block : model.blocks) {
            orbits += block.mass * (block.centroid - middle()).squaredNorm();
            own += block.massMatrix(2, 2);
        }
        return orbits / (orbits + own);
    }

    Point middle() const {
        Point sum(0.0, 0.0);
        double mass = 0.0;
        for (const BlockModel& block : model.blocks) {
            sum += block.mass * block.centroid;
            mass += block.mass;
        }
        return sum / mass;
    }

    const Model model = makeModel(slab());
    State state;

private:
    Engine engine_{model};
    Loads loads_;
};

class Spinning : public testing::TestWithParam<Spin> {};

TEST_P(Spinning, KeepsEnergyUnderNewmarkShiAndGeneralizedAlpha) {
    for (const Inertia scheme : {Inertia::Newmark, Inertia::Shi, Inertia::GeneralizedAlpha}) {
        SpinningCells cells(GetParam().rate);
        const double start = cells.energy();
        ASSERT_TRUE(cells.run(GetParam(), scheme)) << static_cast<int>(scheme);
        EXPECT_NEAR(cells.energy() / start, 1.0, 1e-3) << static_cast<int>(scheme);
        EXPECT_NEAR(energyOf(cells.model, cells.state).balanceError, 0.0, 1e-5) << static_cast<int>(scheme);
    }
}

TEST_P(Spinning, LosesEnergyUnderBackwardEulerByTheClosedForm) {
    SpinningCells cells(GetParam().rate);
    const double start = cells.energy();
    ASSERT_TRUE(cells.run(GetParam(), Inertia::BackwardEuler));
    const auto& [rate, timeStep, duration] = GetParam();
    const double kept = 1.0 / (1.0 + cells.centroidShare() * rate * rate * timeStep * duration);
    EXPECT_NEAR(cells.energy() / start, kept, 0.05 * (1.0 - kept));
    EXPECT_NEAR(energyOf(cells.model, cells.state).balanceError, 0.0, 1e-5);
}

TEST_P(Spinning, KeepsAngularMomentumUnderNewmarkAndShi) {
    for (const Inertia scheme : {Inertia::Newmark, Inertia::Shi}) {
        SpinningCells cells(GetParam().rate, {0.3, -0.2});
        const double start = cells.angularMomentum();
        ASSERT_TRUE(cells.run(GetParam(), scheme)) << static_cast<int>(scheme);
        EXPECT_NEAR(cells.angularMomentum() / start, 1.0, 1e-9) << static_cast<int>(scheme);
    }
}

INSTANTIATE_TEST_SUITE_P(Rates, Spinning,
                         testing::Values(Spin{7.0, 1e-3, 1.0}, Spin{7.0, 5e-3, 2.0}, Spin{1.0, 1e-2, 5.0},
                                         Spin{0.1, 1e-2, 2.0}));

/// Half a radian in a step is too much for generalized-α: it is divided.
TEST(FastSpin, IsFollowedInShorterSteps) {
    for (const Inertia scheme : {Inertia::Newmark, Inertia::Shi, Inertia::GeneralizedAlpha}) {
        SpinningCells cells(50.0);
        const double start = cells.energy();
        ASSERT_TRUE(cells.run({50.0, 0.01, 1.0}, scheme)) << static_cast<int>(scheme);
        EXPECT_NEAR(cells.energy() / start, 1.0, 0.01) << static_cast<int>(scheme);
        EXPECT_NEAR(energyOf(cells.model, cells.state).balanceError, 0.0, 1e-5) << static_cast<int>(scheme);
    }
}

/// Damping by stiffness resists strain, and a turning block has none but that of its spin.
TEST(SpinningCellsDamping, ByStiffnessKeepsTheSpin) {
    for (const Inertia scheme :
         {Inertia::Newmark, Inertia::Shi, Inertia::GeneralizedAlpha}) {
        SpinningCells cells(7.0);
        const double start = cells.energy();
        ASSERT_TRUE(cells.run({7.0, 1e-3, 0.5}, scheme, {0.0, 1e-4})) << static_cast<int>(scheme);
        EXPECT_NEAR(cells.energy() / start, 1.0, 1e-4) << static_cast<int>(scheme);
        EXPECT_NEAR(energyOf(cells.model, cells.state).balanceError, 0.0, 1e-5) << static_cast<int>(scheme);
    }
}

/// Strains are exact at the end of the path for which the links were made, whatever it is.
TEST(GlueLinksOver, AreExactAtTheEndOfTheirPath) {
    SpinningCells cells(7.0);
    const Model& model = cells.model;
    Eigen::VectorXd path = predictedCellPath(model, cells.state, 0.05);
    for (Eigen::Index i = 0; i < path.size(); ++i) path[i] += 1e-5 * std::sin(static_cast<double>(i));
    State after = cells.state;
    for (std::size_t i = 0; i < after.blocks.size(); ++i)
        moveBlock(model.blocks[i], after.blocks[i], path.segment<6>(6 * static_cast<Eigen::Index>(i)));
    StepProblem end;
    end.blocks = static_cast<int>(model.blocks.size());
    addGlueLinks(model, after, end);
    for (const double share : {0.5, 0.6}) {
        StepProblem problem;
        problem.blocks = end.blocks;
        addGlueLinksOver(model, cells.state, path, share, problem);
        std::vector<double> strains;
        linkStrains(problem, path, strains);
        ASSERT_EQ(strains.size(), end.links.size());
        for (std::size_t i = 0; i < strains.size(); ++i) EXPECT_NEAR(strains[i], end.links[i].strain, 1e-15) << i;
        EXPECT_TRUE(glueHolds(model, cells.state.blocks, problem, path));
        EXPECT_FALSE(glueHolds(model, cells.state.blocks, problem, 1.1 * path));
    }
}

/// Cells of a block that turns evenly go round its centroid, whatever its velocity: the glue is not strained.
TEST(PredictedCellPath, IsThatOfARigidBlock) {
    SpinningCells cells(7.0, {3.0, -2.0});
    const Eigen::VectorXd path = predictedCellPath(cells.model, cells.state, 0.01);
    State after = cells.state;
    for (std::size_t i = 0; i < after.blocks.size(); ++i)
        moveBlock(cells.model.blocks[i], after.blocks[i], path.segment<6>(6 * static_cast<Eigen::Index>(i)));
    StepProblem end;
    end.blocks = static_cast<int>(cells.model.blocks.size());
    addGlueLinks(cells.model, after, end);
    for (const Link& link : end.links)  // chords of the speeds as they are, a little short of the arc
        EXPECT_NEAR(link.strain, 0.0, 0.07 * 0.07 * 0.07 / 12.0);
}

}  // namespace
}  // namespace keyblock
