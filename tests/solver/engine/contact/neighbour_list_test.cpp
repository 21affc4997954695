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
#include <random>

namespace keyblock {
namespace {

constexpr int side = 5;

class Random {
public:
    double operator()(double most) { return most * std::uniform_real_distribution<double>(-1.0, 1.0)(engine_); }

private:
    std::mt19937 engine_{11};
};

/// Irregular quadrilaterals of about 1 m that touch each other, every fifth of them cut in two along a diagonal, and one
/// thin sliver.
Scene cells(Random& random) {
    Scene scene = emptyScene(10e9, 0.2, 30.0);
    std::vector<Point> at;
    for (int i = 0; i <= side; ++i)
        for (int k = 0; k <= side; ++k) at.emplace_back(k + random(0.2), i + random(0.2));
    const auto corner = [&](int i, int k) { return at[(side + 1) * i + k]; };
    const auto add = [&](std::vector<Point> points) {
        Block block = boxBlock("", {0, 0}, {1, 1});
        block.points = std::move(points);
        scene.blocks.push_back(std::move(block));
    };
    for (int i = 0; i < side; ++i)
        for (int k = 0; k < side; ++k) {
            const Point a = corner(i, k), b = corner(i, k + 1), c = corner(i + 1, k + 1), d = corner(i + 1, k);
            if ((side * i + k) % 5 != 0) {
                add({a, b, c, d});
                continue;
            }
            add({a, b, c});
            add({a, c, d});
        }
    add({{0.0, -2.0}, {3.0, -2.02}, {3.0, -1.98}});
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

/// Moves of all sizes, from far below the margin to far above it, on paths that are short or long, with margins that
/// change.
TEST(NeighbourList, SearchesWithItFindTheSame) {
    Random random;
    Rock rock(cells(random));
    NeighbourList list;
    std::vector<Contact> contacts = findContacts(rock.model, rock.state.blocks, {}, 1e-3, true);
    std::size_t found = 0;
    for (int n = 0; n < 600; ++n) {
        const double most = std::pow(10.0, -4.0 + (n / 60 % 2 == 0 ? 0.0 : 1.0) + random(1.5));
        const double margin = 4.0 * std::max(1e-3, most) * (1.5 + random(0.5));
        for (Contact& c : contacts) c.normalForce = std::max(0.0, random(1.0));
        ContactSearch search{.margin = margin, .path = n % 3 == 0 ? nullptr : &rock.move, .estimated = n % 2 == 0};
        FoundCorners without, with;
        search.corners = &without;
        const std::vector<Contact> expected = findContacts(rock.model, rock.state.blocks, contacts, search);
        search.corners = &with;
        search.neighbours = &list;
        contacts = findContacts(rock.model, rock.state.blocks, contacts, search);
        ASSERT_EQ(contacts, expected) << n;
        ASSERT_EQ(with.batches.size(), without.batches.size()) << n;
        for (std::size_t i = 0; i < with.batches.size(); ++i) {
            EXPECT_EQ(with.batches[i].pairs.size(), without.batches[i].pairs.size()) << n;
            EXPECT_EQ(with.batches[i].near.size(), without.batches[i].near.size()) << n;
        }
        found += contacts.size();
        rock.shake(random, most);
    }
    EXPECT_GT(found, 600u * 60u);
}

/// A list is used until blocks have moved by what it has beyond the margin, and holds everything near until then.
TEST(NeighbourList, HoldsWhatIsNearUntilItIsMadeAnew) {
    constexpr double margin = 0.02, most = 2e-4;
    Random random;
    Rock rock(cells(random));
    NeighbourList list;
    int kept = 0;
    for (int n = 0; n < 200; ++n) {
        const NeighbourList::Pair* last = list.pairs().data();
        const std::size_t edges = edgesIn(list);
        ASSERT_TRUE(rock.prepare(list, margin)) << n;
        kept += list.pairs().data() == last && edgesIn(list) == edges;
        FoundCorners found;
        findContacts(rock.model, rock.state.blocks, {}, {.margin = margin, .corners = &found});
        EXPECT_TRUE(hasAllNear(list, found)) << n;
        rock.shake(random, most);
    }
    EXPECT_GT(kept, 150);
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
