// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Contact searches with a neighbour list find the same as searches without, and the list lasts as long as blocks move
// little.

#include "solver/engine/contact/neighbour_list.h"
#include "solver/engine/contact/search.h"
#include "solver/engine/setup/make_model.h"
#include "solver/verify/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <tuple>

namespace keyblock {
namespace {

constexpr int side = 5;

class Random {
public:
    double operator()(double most) { return most * std::uniform_real_distribution<double>(-1.0, 1.0)(engine_); }

private:
    std::mt19937 engine_{11};
};

Block blockOf(std::vector<Point> points) {
    Block block = boxBlock("", {0, 0}, {1, 1});
    block.points = std::move(points);
    return block;
}

/// Irregular quadrilaterals of about 1 m that touch each other, every fifth of them cut in two along a diagonal, one
/// divided into cells; beside them a thin sliver, a bar of 5 mm, and an octagon with chamfers of some millimetres.
Scene cells(Random& random) {
    Scene scene = emptyScene(10e9, 0.2, 30.0);
    std::vector<Point> at;
    for (int i = 0; i <= side; ++i)
        for (int k = 0; k <= side; ++k) at.emplace_back(k + random(0.2), i + random(0.2));
    const auto corner = [&](int i, int k) { return at[(side + 1) * i + k]; };
    for (int i = 0; i < side; ++i)
        for (int k = 0; k < side; ++k) {
            const Point a = corner(i, k), b = corner(i, k + 1), c = corner(i + 1, k + 1), d = corner(i + 1, k);
            if ((side * i + k) % 5 != 0) {
                scene.blocks.push_back(blockOf({a, b, c, d}));
                continue;
            }
            scene.blocks.push_back(blockOf({a, b, c}));
            scene.blocks.push_back(blockOf({a, c, d}));
        }
    scene.blocks[2].subBlocks = CellSettings{0.4};
    scene.blocks.push_back(blockOf({{0.0, -2.0}, {3.0, -2.02}, {3.0, -1.98}}));
    scene.blocks.push_back(blockOf({{0.0, -1.97}, {3.0, -1.97}, {3.0, -1.965}, {0.0, -1.965}}));
    scene.blocks.push_back(blockOf({{3.005, -2.0},
                                    {3.4, -2.0},
                                    {3.401, -1.999},
                                    {3.401, -1.6},
                                    {3.398, -1.597},
                                    {3.01, -1.597},
                                    {3.0, -1.607},
                                    {3.0, -1.995}}));
    return scene;
}

struct Rock {
    Model model;
    State state;
    Eigen::VectorXd move;  // over the next search

    explicit Rock(const Scene& scene)
        : model(makeModel(scene)), state(makeState(model)),
          move(Eigen::VectorXd::Zero(6 * static_cast<Eigen::Index>(model.blocks.size()))) {}

    /// Moves every block by up to `most` [m], turns it as much, and strains it a little.
    void shake(Random& random, double most) {
        for (Eigen::Index i = 0; i < move.size(); ++i) move[i] = random(i % 6 < 3 ? most : 1e-3 * most);
        for (std::size_t i = 0; i < model.blocks.size(); ++i)
            moveBlock(model.blocks[i], state.blocks[i], move.segment<6>(6 * static_cast<Eigen::Index>(i)));
    }

    /// Moves single corners by up to `most` [m], so that short edges turn far.
    void moveCorners(Random& random, double most) {
        for (BlockMotion& block : state.blocks)
            for (Point& corner : block.corners) corner += Point(random(most), random(most));
    }

    bool prepare(NeighbourList& list, double margin, double farthest = 0.0) const {
        return list.prepare(model, state.blocks, outlinesOf(model, state.blocks), margin, farthest);
    }
};

std::size_t edgesIn(const NeighbourList& list) {
    std::size_t edges = 0;
    for (const NeighbourList::Pair& pair : list.pairs())
        for (const NeighbourList::Corner& corner : list.corners(pair)) edges += list.turns(corner).size();
    return edges;
}

/// Whether every edge that a search finds near a corner is in the list.
bool hasAllNear(const NeighbourList& list, const FoundCorners& found) {
    const auto isListed = [&](const FoundCorners::Corner& c, int turn) {
        return std::ranges::any_of(list.pairs(), [&](const NeighbourList::Pair& pair) {
            return std::ranges::any_of(list.corners(pair), [&](const NeighbourList::Corner& own) {
                return own.block == c.a && own.corner == c.corner && own.other == c.b &&
                       std::ranges::count(list.turns(own), turn) == 1;
            });
        });
    };
    return std::ranges::all_of(found.batches, [&](const FoundCorners::Batch& batch) {
        return std::ranges::all_of(batch.corners, [&](const FoundCorners::Corner& c) {
            return std::all_of(batch.near.begin() + c.begin, batch.near.begin() + c.end,
                               [&](const NearEdge& near) { return isListed(c, near.turn); });
        });
    });
}

void expectSame(const FoundCorners& with, const FoundCorners& without) {
    ASSERT_EQ(with.batches.size(), without.batches.size());
    for (std::size_t i = 0; i < with.batches.size(); ++i) {
        const FoundCorners::Batch &a = with.batches[i], &b = without.batches[i];
        const auto ofPair = [](const FoundCorners::Pair& p) {
            return std::tuple(p.a, p.b, p.begin, p.end, p.allowedChange);
        };
        const auto ofCorner = [](const FoundCorners::Corner& c) {
            return std::tuple(c.a, c.corner, c.b, c.begin, c.end);
        };
        const auto ofEdge = [](const NearEdge& e) { return std::tuple(e.turn, e.gap, e.along, e.behind); };
        EXPECT_TRUE(std::ranges::equal(a.pairs, b.pairs, {}, ofPair, ofPair));
        EXPECT_TRUE(std::ranges::equal(a.corners, b.corners, {}, ofCorner, ofCorner));
        EXPECT_TRUE(std::ranges::equal(a.near, b.near, {}, ofEdge, ofEdge));
    }
}

/// Moves of all sizes, from far below the margin to far above it, of blocks and of single corners, on paths that are
/// short or long, with margins that change; now and then a block is gone or fixed.
TEST(NeighbourList, SearchesWithItFindTheSame) {
    Random random;
    Rock rock(cells(random));
    NeighbourList list;
    std::vector<Contact> contacts = findContacts(rock.model, rock.state.blocks, {}, 1e-3, true);
    std::size_t found = 0;
    int used = 0;
    for (int n = 0; n < 1200; ++n) {
        const double most = std::pow(10.0, -4.0 + (n / 60 % 3 == 2 ? 1.0 : 0.0) + random(1.0));
        const double margin = 4.0 * std::max(1e-3, most) * (1.5 + random(0.5)) * (n / 25 % 4 == 1 ? 10.0 : 1.0);
        for (Contact& c : contacts) c.normalForce = std::max(0.0, random(1.0));
        rock.state.blocks[n % 17].absent = n % 34 < 17;
        rock.model.blocks[3].fixed = rock.model.blocks[4].fixed = n % 40 < 20;
        ContactSearch search{.margin = margin, .path = n % 3 == 0 ? nullptr : &rock.move, .estimated = n % 2 == 0};
        FoundCorners without, with;
        double releasedWithout = 0.0, releasedWith = 0.0;
        search.corners = &without;
        search.released = &releasedWithout;
        const std::vector<Contact> expected = findContacts(rock.model, rock.state.blocks, contacts, search);
        search.corners = &with;
        search.released = &releasedWith;
        search.neighbours = &list;
        contacts = findContacts(rock.model, rock.state.blocks, contacts, search);
        ASSERT_EQ(contacts, expected) << n;
        ASSERT_EQ(releasedWith, releasedWithout) << n;
        expectSame(with, without);
        ASSERT_FALSE(HasFailure()) << n;
        found += contacts.size();
        used += !list.pairs().empty() && list.searches() > 0 && list.searches() < 40;
        if (n % 5 == 4) rock.moveCorners(random, 0.3 * most);
        else rock.shake(random, most);
    }
    EXPECT_GT(found, 1200u * 60u);
    EXPECT_GT(used, 400);
}

/// A list is used until blocks have moved by what it has beyond the margin, and holds everything near until then.
TEST(NeighbourList, HoldsWhatIsNearUntilItIsReplaced) {
    constexpr double margin = 0.02, most = 2e-4;
    Random random;
    Rock rock(cells(random));
    NeighbourList list;
    int made = 0;
    for (int n = 0; n < 200; ++n) {
        ASSERT_TRUE(rock.prepare(list, margin)) << n;
        made += list.searches() == 0;
        FoundCorners found;
        findContacts(rock.model, rock.state.blocks, {}, {.margin = margin, .corners = &found});
        EXPECT_TRUE(hasAllNear(list, found)) << n;
        rock.shake(random, most);
    }
    EXPECT_GE(made, 2);
    EXPECT_LE(made, 20);
}

/// With a margin of 20 mm a list has 10 mm more: enough until a corner has moved by 5 mm. A wider margin leaves less for
/// moves, and a list with far more than the margin is replaced.
TEST(NeighbourList, IsReplacedOnceACornerHasMovedByHalfOfItsSpare) {
    Random random;
    const Rock rock(cells(random));
    const auto isReplaced = [&](const Point& moved, double margin) {
        NeighbourList list;
        for (int n = 0; n < 20; ++n) EXPECT_TRUE(rock.prepare(list, 0.02));  // the blocks hardly move
        EXPECT_EQ(list.searches(), 19);
        Rock after = rock;
        after.state.blocks[7].corners[1] += moved;
        EXPECT_TRUE(after.prepare(list, margin));
        return list.searches() == 0;
    };
    EXPECT_FALSE(isReplaced({0.0049, 0.0}, 0.02));
    EXPECT_TRUE(isReplaced({0.0051, 0.0}, 0.02));
    EXPECT_FALSE(isReplaced({0.0049, 0.0}, 0.019));
    EXPECT_TRUE(isReplaced({0.0051, 0.0}, 0.019));
    EXPECT_TRUE(isReplaced({0.0049, 0.0}, 0.021));
    EXPECT_FALSE(isReplaced({0.0, 0.0}, 0.01));
    EXPECT_TRUE(isReplaced({0.0, 0.0}, 1e-4));
}

TEST(NeighbourList, IsNotKeptFromPlacesThatAreNoNumbers) {
    Random random;
    Rock rock(cells(random));
    NeighbourList list;
    Point& corner = rock.state.blocks[7].corners[1];
    const Point start = corner;
    EXPECT_TRUE(rock.prepare(list, 0.02));
    corner.x() = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(rock.prepare(list, 0.02));
    corner = start;
    for (int n = 0; n < 40; ++n) rock.prepare(list, 0.02);
    FoundCorners found;
    findContacts(rock.model, rock.state.blocks, {}, {.margin = 0.02, .corners = &found});
    EXPECT_TRUE(hasAllNear(list, found));
    EXPECT_TRUE(rock.prepare(list, 0.02));
    EXPECT_FALSE(rock.prepare(list, 0.02, std::numeric_limits<double>::quiet_NaN()));
}

/// At rest a list lists little more than what is near.
TEST(NeighbourList, IsShort) {
    Random random;
    Rock rock(cells(random));
    NeighbourList list;
    ASSERT_TRUE(rock.prepare(list, 2e-3));
    FoundCorners found;
    findContacts(rock.model, rock.state.blocks, {}, {.margin = 2e-3, .corners = &found});
    std::size_t near = 0;
    for (const FoundCorners::Batch& batch : found.batches) near += batch.near.size();
    EXPECT_GE(edgesIn(list), near);
    EXPECT_LE(edgesIn(list), 3 * near);
}

/// Where blocks move by a tenth of their size from search to search, making lists would be in vain.
TEST(NeighbourList, PausesWhereBlocksMoveFar) {
    Random random;
    Rock rock(cells(random));
    NeighbourList list;
    int used = 0;
    for (int n = 0; n < 330; ++n) {
        used += rock.prepare(list, 0.05);
        rock.shake(random, 0.1);
    }
    EXPECT_GE(used, 5);  // tries again after a pause
    EXPECT_LE(used, 20);
}

TEST(NeighbourList, IsNotUsedForAPathBeyondTheMargin) {
    Random random;
    Rock rock(cells(random));
    NeighbourList list;
    EXPECT_TRUE(rock.prepare(list, 0.01, 0.009));
    EXPECT_FALSE(rock.prepare(list, 0.01, 0.011));
    EXPECT_TRUE(rock.prepare(list, 0.01, 0.009));
}

}  // namespace
}  // namespace keyblock
