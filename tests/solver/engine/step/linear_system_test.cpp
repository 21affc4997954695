// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The sparse solver against dense algebra, small (simplicial) and large
// (supernodal), and what it says of systems that hold nothing in place.
#include "solver/engine/step/linear_system.h"
#include "solver/engine/step/nested_dissection.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <thread>

namespace keyblock {
namespace {

using Entries = std::vector<std::pair<int, int>>;

struct Spring {
    int a = 0, b = 0;
    double stiffness = 1.0;
};

/// Springs between unknowns, each unknown held to the ground by `ground`.
class SpringNet {
public:
    /// \param groups as in `LinearSystem::analyse`.
    SpringNet(int n, std::vector<Spring> springs, const std::vector<int>& groups = {})
        : n_(n), springs_(std::move(springs)) {
        Entries entries;
        for (const Spring& spring : springs_) {
            entries.emplace_back(spring.a, spring.b);
            entries.emplace_back(spring.b, spring.a);  // repeats, from both triangles
        }
        system.analyse(n, entries, groups);
    }

    void assemble(const std::vector<double>& ground) {
        system.clear();
        const auto add = [&](int i, int j, double value) {
            system.values()[system.slot(i, j)] += value;
        };
        for (int i = 0; i < n_; ++i) add(i, i, ground[i]);
        for (const Spring& spring : springs_) {
            add(spring.a, spring.a, spring.stiffness);
            add(spring.b, spring.b, spring.stiffness);
            add(spring.a, spring.b, -spring.stiffness);
        }
    }

    Eigen::MatrixXd dense(const std::vector<double>& ground) const {
        Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n_, n_);
        for (int i = 0; i < n_; ++i) matrix(i, i) = ground[i];
        for (const Spring& s : springs_) {
            matrix(s.a, s.a) += s.stiffness;
            matrix(s.b, s.b) += s.stiffness;
            matrix(s.a, s.b) -= s.stiffness;
            matrix(s.b, s.a) -= s.stiffness;
        }
        return matrix;
    }

    LinearSystem system;

private:
    int n_;
    std::vector<Spring> springs_;
};

/// Random net of few neighbours: sparse, small factor.
std::vector<Spring> looseNet(int n) {
    std::mt19937 random(3);
    std::vector<Spring> springs;
    for (int i = 1; i < n; ++i)
        springs.push_back({i, static_cast<int>(random() % static_cast<unsigned>(i)), 1.0 + static_cast<double>(random() % 100)});
    return springs;
}

/// Square net in which each unknown has 24 neighbours: dense columns, supernodal.
std::vector<Spring> denseNet(int side) {
    std::vector<Spring> springs;
    const auto unknown = [&](int x, int y) { return y * side + x; };
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
            for (int dy = 0; dy <= 2; ++dy)
                for (int dx = -2; dx <= 2; ++dx) {
                    if ((dy == 0 && dx <= 0) || x + dx < 0 || x + dx >= side || y + dy >= side) continue;
                    springs.push_back({unknown(x, y), unknown(x + dx, y + dy), 1.0 + ((x * 7 + y * 3 + dx) % 5)});
                }
    return springs;
}

std::vector<double> someLoad(int n) {
    std::vector<double> load(n);
    for (int i = 0; i < n; ++i) load[i] = std::sin(1.0 + i);
    return load;
}

double largest(const Eigen::VectorXd& v) { return v.cwiseAbs().maxCoeff(); }

void expectSolves(int n, const std::vector<Spring>& springs) {
    SpringNet net(n, springs);
    const std::vector<double> ground(n, 0.5);
    net.assemble(ground);
    ASSERT_EQ(net.system.factor(), -1);

    const std::vector<double> load = someLoad(n);
    std::vector<double> x(load.size());
    net.system.solve(load, x, 1);

    const Eigen::MatrixXd matrix = net.dense(ground);
    const Eigen::VectorXd b = Eigen::Map<const Eigen::VectorXd>(load.data(), n);
    const Eigen::VectorXd solution = Eigen::Map<const Eigen::VectorXd>(x.data(), n);
    // Backward stable: the residual is round-off of the sum in a row.
    const double rowSum = matrix.cwiseAbs().rowwise().sum().maxCoeff();
    EXPECT_LE(largest(matrix * solution - b), 1e-14 * (rowSum * largest(solution) + largest(b)));

    std::vector<double> product(load.size());
    net.system.multiply(x, product);
    EXPECT_LE(largest(Eigen::Map<Eigen::VectorXd>(product.data(), n) - b),
              1e-14 * (rowSum * largest(solution) + largest(b)));
}

TEST(LinearSystem, SolvesASmallSystem) { expectSolves(40, looseNet(40)); }

TEST(LinearSystem, SolvesALargeDenseSystem) { expectSolves(900, denseNet(30)); }

/// A spring's column: stiffness·(eₐ − e_b)(eₐ − e_b)ᵀ is its product with itself.
SparseColumn columnOf(const Spring& spring) {
    const double root = std::sqrt(spring.stiffness);
    return {{spring.a, root}, {spring.b, -root}};
}

/// Springs taken away and others made stiffer, by ranks: the same answer as by a factor of the changed net.
void expectFollowsChanges(int n, const std::vector<Spring>& springs) {
    SpringNet net(n, springs);
    const std::vector<double> ground(n, 0.5);
    net.assemble(ground);
    ASSERT_EQ(net.system.factor(), -1);
    EXPECT_GT(net.system.worthwhileRanks(), 0);
    Eigen::MatrixXd matrix = net.dense(ground);
    std::vector<SparseColumn> more, less;
    for (std::size_t i = 0; i < springs.size(); i += 7) {
        const bool add = i % 2 == 0;
        (add ? more : less).push_back(columnOf(springs[i]));
        Eigen::VectorXd column = Eigen::VectorXd::Zero(n);
        for (const auto& [row, value] : columnOf(springs[i])) column[row] = value;
        matrix += (add ? 1.0 : -1.0) * column * column.transpose();
    }
    ASSERT_TRUE(net.system.addRanks(more));
    ASSERT_TRUE(net.system.takeRanks(less));
    const std::vector<double> load = someLoad(n);
    std::vector<double> x(load.size());
    net.system.solve(load, x);
    const Eigen::VectorXd solution = Eigen::Map<const Eigen::VectorXd>(x.data(), n);
    const Eigen::VectorXd b = Eigen::Map<const Eigen::VectorXd>(load.data(), n);
    const double rowSum = matrix.cwiseAbs().rowwise().sum().maxCoeff();
    EXPECT_LE(largest(matrix * solution - b), 1e-12 * (rowSum * largest(solution) + largest(b)));
    // the values are still those of the net as it was, and factoring takes the changes back
    ASSERT_EQ(net.system.factor(), -1);
    net.system.solve(load, x);
    EXPECT_LE(largest(net.dense(ground) * Eigen::Map<const Eigen::VectorXd>(x.data(), n) - b),
              1e-12 * (rowSum * largest(solution) + largest(b)));
}

TEST(LinearSystem, FollowsASmallSystemByRanks) { expectFollowsChanges(40, looseNet(40)); }

TEST(LinearSystem, FollowsALargeSystemByRanks) { expectFollowsChanges(900, denseNet(30)); }

TEST(LinearSystem, RefusesToTakeMoreThanThereIs) {
    SpringNet net(2, {{0, 1, 3.0}});
    net.assemble({1.0, 1.0});
    ASSERT_EQ(net.system.factor(), -1);
    EXPECT_FALSE(net.system.takeRanks(std::vector<SparseColumn>{columnOf({0, 1, 5.0})}));
    ASSERT_EQ(net.system.factor(), -1);  // usable again
}

TEST(LinearSystem, FollowsALargeSystemAgainAfterARefusal) {
    const int n = 900;
    const std::vector<Spring> springs = denseNet(30);
    const std::vector<double> ground(n, 1.0);
    SpringNet net(n, springs);
    net.assemble(ground);
    ASSERT_EQ(net.system.factor(), -1);
    Spring tooMuch = springs.front(), more = springs.back();
    tooMuch.stiffness *= 1e6;
    EXPECT_FALSE(net.system.takeRanks(std::vector<SparseColumn>{columnOf(springs[7]), columnOf(tooMuch)}));
    ASSERT_EQ(net.system.factor(), -1);
    ASSERT_TRUE(net.system.addRanks(std::vector<SparseColumn>{columnOf(more)}));
    const std::vector<double> load = someLoad(n);
    std::vector<double> x(load.size());
    net.system.solve(load, x);
    Eigen::VectorXd column = Eigen::VectorXd::Zero(n);
    for (const auto& [row, value] : columnOf(more)) column[row] = value;
    const Eigen::MatrixXd matrix = net.dense(ground) + column * column.transpose();
    const Eigen::VectorXd solution = Eigen::Map<const Eigen::VectorXd>(x.data(), n);
    const Eigen::VectorXd b = Eigen::Map<const Eigen::VectorXd>(load.data(), n);
    EXPECT_LE(largest(matrix * solution - b), 1e-12 * matrix.cwiseAbs().rowwise().sum().maxCoeff() * largest(solution));
}

TEST(LinearSystem, SolvesOneUnknownAndNone) {
    LinearSystem system;
    system.analyse(1, {});
    system.values()[0] = 4.0;
    ASSERT_EQ(system.factor(), -1);
    std::vector<double> x{0.0};
    system.solve(std::vector<double>{2.0}, x);
    EXPECT_EQ(x[0], 0.5);

    system.analyse(0, {});
    EXPECT_EQ(system.factor(), -1);
    EXPECT_EQ(system.size(), 0);
}

TEST(LinearSystem, KeepsThePatternAndTakesNewValues) {
    SpringNet net(60, looseNet(60));
    std::vector<double> ground(60, 1.0);
    net.assemble(ground);
    ASSERT_EQ(net.system.factor(), -1);
    ground[17] = 1e6;
    net.assemble(ground);
    ASSERT_EQ(net.system.factor(), -1);
    const std::vector<double> load = someLoad(60);
    std::vector<double> x(60);
    net.system.solve(load, x);
    const Eigen::VectorXd expected =
        net.dense(ground).ldlt().solve(Eigen::Map<const Eigen::VectorXd>(load.data(), 60));
    EXPECT_LE(largest(Eigen::Map<Eigen::VectorXd>(x.data(), 60) - expected), 1e-10 * largest(expected));
}

TEST(LinearSystem, NamesALooseUnknown) {
    SpringNet net(50, {{0, 1, 2.0}, {1, 2, 2.0}});  // the others hold to the ground alone
    std::vector<double> ground(50, 1.0);
    ground[33] = 0.0;
    net.assemble(ground);
    EXPECT_EQ(net.system.factor(), 33);
}

TEST(LinearSystem, NamesAMemberOfALooseGroup) {
    // Unknowns 10, 20, 30 are tied together and to nothing else. Their last pivot is round-off of either sign.
    SpringNet net(50, {{10, 20, 3e9}, {20, 30, 1e9 / 3.0}, {1, 2, 1.0}});
    std::vector<double> ground(50, 1.0);
    for (const int loose : {10, 20, 30}) ground[loose] = 0.0;
    net.assemble(ground);
    const int failed = net.system.factor();
    EXPECT_TRUE(failed == 10 || failed == 20 || failed == 30) << failed;
}

TEST(LinearSystem, NamesTheLoosePartOfALargeSystem) {
    const int side = 30;
    SpringNet net(side * side + 1, denseNet(side));
    std::vector<double> ground(side * side + 1, 1.0);
    ground.back() = 0.0;
    net.assemble(ground);
    EXPECT_EQ(net.system.factor(), side * side);
}

TEST(LinearSystem, RefusesNegativeStiffnessAndNaN) {
    SpringNet net(20, looseNet(20));
    std::vector<double> ground(20, 1.0);
    ground[4] = -1e4;
    net.assemble(ground);
    EXPECT_GE(net.system.factor(), 0);
    ground[4] = std::numeric_limits<double>::quiet_NaN();
    net.assemble(ground);
    EXPECT_GE(net.system.factor(), 0);
}

TEST(LinearSystem, WorksAgainAfterAFailure) {
    SpringNet net(20, looseNet(20));
    net.assemble(std::vector<double>(20, 0.0));
    EXPECT_GE(net.system.factor(), 0);
    net.assemble(std::vector<double>(20, 1.0));
    EXPECT_EQ(net.system.factor(), -1);
}

TEST(LinearSystem, AcceptsAMassThatIsSmallBesideTheSprings) {
    // Two masses of 1 tied by a spring of 1e12: floating but for their inertia, and well posed.
    SpringNet net(2, {{0, 1, 1e12}});
    net.assemble({1.0, 1.0});
    ASSERT_EQ(net.system.factor(), -1);
    std::vector<double> x(2);
    net.system.solve(std::vector<double>{1.0, 1.0}, x, 1);
    EXPECT_NEAR(x[0], 1.0, 1e-3);  // the pivot keeps 52 − 40 bits
}

/// Bits of a large solution found on a thread of its own.
std::vector<double> solutionOnOwnThread() {
    std::vector<double> x(900);
    std::thread worker([&] {
        SpringNet net(900, denseNet(30));
        net.assemble(std::vector<double>(900, 0.25));
        if (net.system.factor() == -1) net.system.solve(someLoad(900), x);
    });
    worker.join();
    return x;
}

TEST(LinearSystem, GivesTheSameBitsOnAnyThread) {
    SpringNet net(900, denseNet(30));
    net.assemble(std::vector<double>(900, 0.25));
    ASSERT_EQ(net.system.factor(), -1);
    std::vector<double> x(900);
    net.system.solve(someLoad(900), x);
    EXPECT_EQ(solutionOnOwnThread(), x);
    EXPECT_NE(x, std::vector<double>(900));
}

constexpr int wideSide = 140;  // of a net so large that its factor is divided among threads

struct Solved {
    int loose = -1;
    std::vector<double> x;

    bool operator==(const Solved&) const = default;
};

/// The wide net solved with a number of threads, of which there may be more than cores.
Solved solvedWith(int threads, const std::vector<double>& ground) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    const int n = wideSide * wideSide;
    SpringNet net(n, denseNet(wideSide));
    net.assemble(ground);
    Solved solved{0, std::vector<double>(n)};
    const std::vector<double> load = someLoad(n);
    tbb::task_arena(threads).execute([&] {
        solved.loose = net.system.factor();
        if (solved.loose < 0) net.system.solve(load, solved.x);
    });
    if (solved.loose >= 0) return solved;
    std::vector<double> force(n);
    net.system.multiply(solved.x, force);
    for (int i = 0; i < n; ++i) EXPECT_NEAR(force[i], load[i], 1e-11);
    return solved;
}

TEST(LinearSystem, GivesTheSameBitsOnAnyNumberOfThreads) {
    const std::vector<double> ground(wideSide * wideSide, 0.25);
    const Solved alone = solvedWith(1, ground);
    EXPECT_EQ(alone.loose, -1);
    EXPECT_EQ(solvedWith(2, ground), alone);
    EXPECT_EQ(solvedWith(4, ground), alone);
}

TEST(LinearSystem, NamesTheSameLooseUnknownOnAnyNumberOfThreads) {
    std::vector<double> ground(wideSide * wideSide, 0.25);
    ground[wideSide + 1] = ground[wideSide * wideSide - wideSide - 2] = -1e4;
    const Solved alone = solvedWith(1, ground);
    EXPECT_GE(alone.loose, 0);
    EXPECT_EQ(solvedWith(4, ground), alone);
}

/// For a wide net of few neighbours the factor by nested dissection is smaller and solves as well; groups that save no
/// operations are not used.
TEST(LinearSystem, UsesGroupsThatSaveOperations) {
    constexpr int side = 200, n = side * side;
    std::vector<Spring> springs;
    Entries pairs;
    std::vector<Eigen::Vector2d> places(n);
    for (int i = 0; i < n; ++i) {
        places[i] = {i % side, i / side};
        for (const int other : {i + 1, i + side, i + side + 1})
            if (other < n && other % side >= i % side) springs.push_back({i, other});
    }
    for (const Spring& spring : springs) pairs.emplace_back(spring.a, spring.b);
    const double byDegree = SpringNet(n, springs).system.factorEntries();
    SpringNet net(n, springs, nestedDissection(places, pairs));
    EXPECT_LT(net.system.factorEntries(), 0.95 * byDegree);
    net.assemble(std::vector<double>(n, 0.25));
    ASSERT_EQ(net.system.factor(), -1);
    const std::vector<double> load = someLoad(n);
    std::vector<double> x(n), force(n);
    net.system.solve(load, x);
    net.system.multiply(x, force);
    for (int i = 0; i < n; ++i) EXPECT_NEAR(force[i], load[i], 1e-11);
    std::vector<int> rows(n);
    for (int i = 0; i < n; ++i) rows[i] = i / side;
    EXPECT_EQ(SpringNet(n, springs, rows).system.factorEntries(), byDegree);
}

}  // namespace
}  // namespace keyblock
