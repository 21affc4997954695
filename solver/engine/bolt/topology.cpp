// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/bolt/topology.h"

#include "geometry/polygon.h"
#include "geometry/segment.h"
#include "solver/engine/bolt/anchor.h"
#include "solver/engine/bolt/bolt.h"
#include "solver/engine/bolt/slot_line.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace keyblock {
namespace {

constexpr double cellSlack = 1e-3;  // of a cell's size: largest gap between two glued cells
constexpr double endShare = 0.01;  // of the element at an end of the bar: its block is looked up this far inside
constexpr int several = -2;  // the point lies on faces of more than one block
constexpr double countedShare = 1e-10;  // of the bolt's length: smaller changes of embedded length change no energy

/// Total length of the parts of `pieces` that lie in `intervals` and between `from` and `to` [m].
double overlapOf(const std::vector<Interval>& pieces, const std::vector<Interval>& intervals, double from, double to) {
    double sum = 0.0;
    for (const auto& [a, b] : pieces)
        for (const auto& [c, d] : intervals) sum += std::max(0.0, std::min({b, d, to}) - std::max({a, c, from}));
    return sum;
}

class BoltPlaces {
public:
    BoltPlaces(const Model& model, State& state, int bolt)
        : model_(model), state_(state), bolt_(model.bolts[bolt]), motion_(state.bolts[bolt]), index_(bolt) {}

    void start() {
        for (int n = 0; n < nodes(); ++n) {
            const int block = bolt_.startBlock[n];
            if (block < 0) continue;
            place(n, block);
            motion_.nodes[n].bond.bonded = bolt_.anchors[n].real;
        }
        share();
    }

    /// Places the nodes in the blocks as they are now.
    void startNow() {
        for (int n = 0; n < nodes(); ++n) {
            const int block = find(n, -1);
            if (block < 0) continue;
            place(n, block);
            motion_.nodes[n].bond.bonded = bolt_.anchors[n].real;
        }
        share();
    }

    double follow() {
        const std::vector<BoltNode> before = motion_.nodes;
        std::vector<int> entered;
        for (int n = 0; n < nodes(); ++n) {
            const int was = blockOf(n);
            const int now = find(n, was);
            if (now == was) continue;
            if (now >= 0 && was >= 0 && sameRock(model_, now, was)) {
                pass(n, now);
                continue;
            }
            leaveRock(bolt_.anchors[n], motion_.nodes[n]);
            if (now < 0) continue;
            place(n, now);
            entered.push_back(n);
        }
        for (int n : entered) enter(n, neighbourOf(n, entered));
        share();
        double change = 0.0;
        for (int n = 0; n < nodes(); ++n)
            change = std::max({change, std::abs(motion_.nodes[n].bond.share - before[n].bond.share),
                               std::abs(motion_.nodes[n].normalShare - before[n].normalShare)});
        if (change > countedShare * bolt_.s.back()) accountFor(before);
        return change;
    }

private:
    int nodes() const { return static_cast<int>(motion_.nodes.size()); }

    int blockOf(int n) const {
        const int slot = motion_.nodes[n].slot;
        return slot < 0 ? -1 : motion_.slots[slot].block;
    }

    Side sideOf(int block, const Point& x) const { return locate(state_.blocks[block].corners, x, model_.tolerance); }

    /// The block that contains the node, or the only one on whose face the node lies; −1 if there is none. An end of
    /// the bar that lies on a joint belongs to the block that the bar runs into.
    int find(int n, int before) const {
        const Point& x = motion_.nodes[n].x;
        const int there = findAt(n, x, before);
        if (there != several) return there;
        if (n > 0 && n + 1 < nodes()) return -1;
        const Point& next = motion_.nodes[n == 0 ? 1 : n - 1].x;
        return std::max(-1, findAt(n, x + endShare * (next - x), before));
    }

    int findAt(int n, const Point& x, int before) const {
        if (before >= 0 && state_.blocks[before].absent) before = -1;
        if (before >= 0 && sideOf(before, x) == Side::Inside) return before;
        if (before >= 0 && model_.blocks[before].cell)
            if (const int cell = findCell(n, before); cell >= 0) return cell;
        int onFace = -1, faces = 0;
        for (int b = 0; b < model_.firstOf.back(); ++b) {  // plates are not rock
            if (state_.blocks[b].absent) continue;
            if (onFace >= 0 && sameRock(model_, onFace, b)) continue;  // between cells of one block: the first cell
            const Point away = x - state_.blocks[b].centroid;
            if (away.squaredNorm() > 4.0 * reachOf(b) * reachOf(b)) continue;
            const Side side = sideOf(b, x);
            if (side == Side::Inside) return b;
            if (side == Side::Outside) continue;
            onFace = b;
            ++faces;
        }
        return faces == 1 ? onFace : faces > 1 ? several : -1;
    }

    /// Finds the cell within the same block. A bonded node stays with its cell; any other node goes to the cell that
    /// contains it. Between cells that are glued with a small gap, the node keeps its cell. −1 if it has left the
    /// block.
    int findCell(int n, int before) const {
        const BoltNode& node = motion_.nodes[n];
        const std::size_t rock = model_.blocks[before].rock;
        int beside = 0;
        for (int cell = model_.firstOf[rock]; cell < model_.firstOf[rock + 1]; ++cell) {
            const double slack = cellSlack * model_.blocks[cell].size, reach = reachOf(cell);
            if ((node.x - state_.blocks[cell].centroid).squaredNorm() > 4.0 * reach * reach) continue;
            if (sideOf(cell, node.x) == Side::Inside) return node.bond.bonded ? before : cell;
            if (locate(state_.blocks[cell].corners, node.x, slack) == Side::Boundary) ++beside;
        }
        return beside > 1 ? before : -1;
    }

    double reachOf(int block) const {
        double reach = 0.0;
        for (const Point& corner : model_.blocks[block].shape) reach = std::max(reach, corner.squaredNorm());
        return std::sqrt(reach);
    }

    Point direction(int n) const {
        const int a = std::max(0, n - 1), b = std::min(nodes() - 1, n + 1);
        return (motion_.nodes[b].x - motion_.nodes[a].x).normalized();
    }

    /// The slot of the block along which the node lies; a new slot is made if the bolt has none in this block.
    int slotIn(int n, int block) {
        int best = -1;
        double nearest = 0.0;
        for (int i = 0; i < static_cast<int>(motion_.slots.size()); ++i) {
            if (motion_.slots[i].block != block) continue;
            const SlotLine line = slotLine(state_, motion_.slots[i]);
            const double along = line.along.dot(motion_.nodes[n].x - line.p2);
            const double outside = std::max({0.0, -along, along - line.length});
            if (best < 0 || outside < nearest) best = i, nearest = outside;
        }
        if (best >= 0) return best;
        const BlockMotion& rock = state_.blocks[block];
        const Point& x = motion_.nodes[n].x;
        const double reach = bolt_.elements[std::min(n, nodes() - 2)].length;
        motion_.slots.push_back({block, materialPlace(rock, x), materialPlace(rock, x + reach * direction(n)),
                                 bolt_.s[n], bolt_.s[n] + reach});
        motion_.leftSlot.push_back(0);
        return static_cast<int>(motion_.slots.size()) - 1;
    }

    void place(int n, int block) {
        BoltNode& node = motion_.nodes[n];
        node.slot = slotIn(n, block);
        const SlotLine line = slotLine(state_, motion_.slots[node.slot]);
        node.bond.place = line.along.dot(node.x - line.p2) / line.length;
        node.normalOffset = offSlot(line, node);  // outside the hole, the node makes its own and starts without force
        node.bond.offset = 0.0;
        node.bond.curve = {};
    }

    /// Moves the node into the next cell of the same block and keeps its force.
    void pass(int n, int block) {
        BoltNode& node = motion_.nodes[n];
        const double along = alongSlot(slotLine(state_, motion_.slots[node.slot]), node);
        node.slot = slotIn(n, block);
        const SlotLine line = slotLine(state_, motion_.slots[node.slot]);
        node.bond.place = (line.along.dot(node.x - line.p2) - along) / line.length;
    }

    /// The cells of a block count as one block, which is represented by its first row.
    int wholeOf(int block) const {
        return block >= 0 && model_.blocks[block].cell ? model_.firstOf[model_.blocks[block].rock] : block;
    }

    int wholeAt(int n) const { return wholeOf(blockOf(n)); }

    /// Adds the block or, if it is a cell, all cells of its block.
    void addWhole(int block, std::vector<int>& blocks) const {
        if (block < 0 || !model_.blocks[block].cell) {
            blocks.push_back(block);
            return;
        }
        const std::size_t rock = model_.blocks[block].rock;
        for (int cell = model_.firstOf[rock]; cell < model_.firstOf[rock + 1]; ++cell) blocks.push_back(cell);
    }

    /// Parts of an element inside a block, as fractions of its length. A bolt along the edge between two cells counts
    /// as inside one of them.
    std::vector<std::pair<double, double>> insideOf(int block, Point a, Point b) const {
        if (model_.blocks[block].cell) {
            const double reach = reachOf(block) + (b - a).norm();
            if ((a - state_.blocks[block].centroid).squaredNorm() > 4.0 * reach * reach) return {};
            const Point aside = 4.0 * model_.tolerance * turnLeft((b - a).normalized());
            a += aside;
            b += aside;
        }
        return insideIntervals(state_.blocks[block].corners, a, b, model_.tolerance);
    }

    /// The nearest node along the bolt that was already in the same block; −1 if there is none.
    int neighbourOf(int n, const std::vector<int>& entered) const {
        for (int away = 1; away < nodes(); ++away)
            for (int m : {n - away, n + away})
                if (m >= 0 && m < nodes() && wholeAt(m) == wholeAt(n) &&
                    !std::binary_search(entered.begin(), entered.end(), m))
                    return m;
        return -1;
    }

    void enter(int n, int neighbour) {
        NodeBond& bond = motion_.nodes[n].bond;
        if (neighbour < 0) {
            enterRock(bolt_.anchors[n], nullptr, bond);
            return;
        }
        const AnchorNeighbour beside{bolt_.anchors[neighbour], motion_.nodes[neighbour].bond};
        enterRock(bolt_.anchors[n], &beside, bond);
    }

    /// Length that leaves the rock releases its stored energy. The energy stored in length that enters the rock is
    /// taken from the work of friction.
    void accountFor(const std::vector<BoltNode>& before) {
        const double now = boltEnergy(model_, state_, index_);
        std::vector<BoltNode> nodes = before;
        nodes.swap(motion_.nodes);
        const double lost = boltEnergy(model_, state_, index_) - now;
        nodes.swap(motion_.nodes);
        (lost > 0.0 ? state_.energy.released : state_.energy.friction) += lost;
        motion_.bondEnergy += lost;
    }

    /// Intervals of the bolt in each block, with all cells of a block taken together. An element with both nodes in one
    /// block lies entirely in that block.
    std::map<int, std::vector<Interval>> embedded() const {
        std::map<int, std::vector<Interval>> pieces;
        for (int e = 0; e + 1 < nodes(); ++e) {
            const int b1 = wholeAt(e), b2 = wholeAt(e + 1);
            const double s = bolt_.s[e], length = bolt_.elements[e].length;
            if (b1 >= 0 && b1 == b2) {
                pieces[b1].emplace_back(s, s + length);
                continue;
            }
            std::vector<int> blocks;
            for (int block : {blockOf(e), blockOf(e + 1)}) addWhole(block, blocks);
            for (const Slot& slot : motion_.slots) addWhole(slot.block, blocks);
            std::sort(blocks.begin(), blocks.end());
            blocks.erase(std::unique(blocks.begin(), blocks.end()), blocks.end());
            for (int block : blocks) {
                if (block < 0 || state_.blocks[block].absent) continue;
                for (const auto& [f, t] : insideOf(block, motion_.nodes[e].x, motion_.nodes[e + 1].x))
                    pieces[wholeOf(block)].emplace_back(s + f * length, s + t * length);
            }
        }
        for (auto& [block, own] : pieces) join(own);
        return pieces;
    }

    /// Joins adjoining intervals. They are sorted first, because cells come in the order of their rows, in whichever
    /// direction the bolt runs.
    void join(std::vector<Interval>& pieces) const {
        std::sort(pieces.begin(), pieces.end());
        std::size_t last = 0;
        for (std::size_t i = 1; i < pieces.size(); ++i) {
            if (pieces[i].first - pieces[last].second < 1e-12 * bolt_.s.back())
                pieces[last].second = std::max(pieces[last].second, pieces[i].second);
            else
                pieces[++last] = pieces[i];
        }
        pieces.resize(std::min(pieces.size(), last + 1));
    }

    double tributaryFrom(int n) const { return n == 0 ? bolt_.s[0] : 0.5 * (bolt_.s[n - 1] + bolt_.s[n]); }
    double tributaryTo(int n) const { return n + 1 == nodes() ? bolt_.s[n] : 0.5 * (bolt_.s[n] + bolt_.s[n + 1]); }

    /// Distributes the length embedded in each block, within the intervals of an entry, among the nodes of that entry
    /// in the block.
    template <class Entry, class Set>
    void shareLength(const std::map<int, std::vector<Interval>>& pieces,
                     const std::vector<std::vector<Interval>>& intervals, Entry entryOf, Set set) {
        std::map<std::pair<int, int>, double> weights;  // by block and entry
        std::vector<double> own(nodes(), 0.0);
        const auto counts = [&](int n) { return entryOf(n) >= 0 && pieces.contains(wholeAt(n)); };
        for (int n = 0; n < nodes(); ++n) {
            if (!counts(n)) continue;
            own[n] = overlapOf(pieces.at(wholeAt(n)), intervals[entryOf(n)], tributaryFrom(n), tributaryTo(n));
            weights[{wholeAt(n), entryOf(n)}] += own[n];
        }
        for (int n = 0; n < nodes(); ++n) {
            const double weight = counts(n) ? weights[{wholeAt(n), entryOf(n)}] : 0.0;
            const double whole =
                weight > 0.0 ? overlapOf(pieces.at(wholeAt(n)), intervals[entryOf(n)], 0.0, bolt_.s.back()) : 0.0;
            set(n, weight > 0.0 ? whole * own[n] / weight : 0.0);
        }
    }

    void share() {
        const auto pieces = embedded();
        shareLength(
            pieces, bolt_.intervals,
            [&](int n) { return bolt_.anchors[n].per == Per::Length ? bolt_.anchors[n].entry : -1; },
            [&](int n, double share) { motion_.nodes[n].bond.share = share; });
        shareLength(
            pieces, {{{0.0, bolt_.s.back()}}}, [&](int) { return bolt_.normalPer == Per::Length ? 0 : -1; },
            [&](int n, double share) { motion_.nodes[n].normalShare = share; });
        for (int n = 0; n < nodes(); ++n) {
            const double in = blockOf(n) >= 0 ? 1.0 : 0.0;
            if (bolt_.anchors[n].per == Per::Node) motion_.nodes[n].bond.share = in;
            if (bolt_.normalPer == Per::Node) motion_.nodes[n].normalShare = in;
        }
    }

    const Model& model_;
    State& state_;
    const BoltModel& bolt_;
    BoltMotion& motion_;
    int index_;
};

}  // namespace

void placeBolts(const Model& model, State& state) {
    for (std::size_t b = 0; b < model.bolts.size(); ++b)
        if (!state.bolts[b].absent) BoltPlaces(model, state, static_cast<int>(b)).start();
}

void placeBoltNow(const Model& model, State& state, int bolt) { BoltPlaces(model, state, bolt).startNow(); }

double followBolts(const Model& model, State& state) {
    double change = 0.0;
    for (std::size_t b = 0; b < model.bolts.size(); ++b) {
        if (!acts(state.bolts[b])) continue;
        change = std::max(change, BoltPlaces(model, state, static_cast<int>(b)).follow());
    }
    return change;
}

}  // namespace keyblock
