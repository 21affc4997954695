// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/stage/falls.h"

#include <cmath>
#include <utility>

namespace keyblock {
namespace {

// number of pseudo-steps over which a fall must not slow down: at first, and if it was seen before
constexpr std::size_t manySteps = 11, fewSteps = 4;
constexpr double steady = 0.95;  // fraction of the acceleration at their beginning
constexpr double alike = 0.2;  // relative difference up to which two accelerations are alike
constexpr double quick = 10.0;  // times the unbalanced force allowed at rest
// displacement over block size from which a quick fall, or any fall, is accepted
constexpr double shortWay = 0.1, longWay = 0.5;
constexpr double leastWay = 0.05;  // displacement over block size from which a block counts as set in motion by others

}  // namespace

Falls::Falls(const Model& model, const State& state, const FallSettings& settings)
    : model_(model), share_(settings.share), remembered_(settings.from ? fewSteps : manySteps),
      bolted_(state.blocks.size(), 0) {
    for (std::size_t row = 0; row < state.blocks.size(); ++row) {
        const int first = wholeOf(model, static_cast<int>(row));
        places_.push_back(settings.from ? (*settings.from)[row] : state.blocks[row].centroid);
        sizes_.push_back(wholeSize(model, first));
        small_.push_back(model.blocks[row].plateOf < 0 && wholeArea(model, first) < settings.smallest);
    }
    for (const BoltMotion& bolt : state.bolts)
        for (const Slot& slot : bolt.slots)
            if (!bolt.lost && !bolt.absent) bolted_[slot.block] = 1;
}

void Falls::note(const std::vector<double>& moves, double dt, const std::vector<double>& own) {
    std::vector<double> accelerations;
    for (std::size_t i = 0; i < moves.size(); ++i)
        accelerations.push_back(model_.blocks[i].mass * 2.0 * moves[i] / (dt * dt) / own[i]);
    accelerations_.push_back(std::move(accelerations));
    moves_.push_back(moves);
    if (accelerations_.size() <= remembered_) return;
    accelerations_.pop_front();
    moves_.pop_front();
}

bool Falls::falls(const std::vector<BlockMotion>& blocks, int block) const {
    const std::size_t at = block;
    if (accelerations_.size() < remembered_ || model_.blocks[at].plateOf >= 0) return false;
    const double now = accelerations_.back()[at], way = moved(blocks, block);
    if (now < steady * accelerations_.front()[at] || isCaught(block)) return false;
    return (now > quick * share_ && way > shortWay) || (now > share_ && way > longWay);
}

/// True if the acceleration of a bolted block decreases so fast that its bolts stop it before it has moved by its size.
bool Falls::isCaught(int block) const {
    const std::size_t at = block;
    if (!bolted_[at]) return false;
    double way = 0.0;
    for (std::size_t step = 1; step < moves_.size(); ++step) way += moves_[step][at];
    const double now = accelerations_.back()[at], taken = accelerations_.front()[at] - now;
    return taken * sizes_[at] > now * way;
}

bool Falls::sameWhateverTheStep(int block) const {
    const std::size_t at = block;
    const double now = accelerations_.back()[at], before = accelerations_[accelerations_.size() - 2][at];
    return std::abs(now - before) <= alike * before;
}

bool Falls::follows(const std::vector<BlockMotion>& blocks, int block) const {
    const std::size_t at = block;
    if (accelerations_.empty() || model_.blocks[at].plateOf >= 0) return false;
    return accelerations_.back()[at] > share_ && moved(blocks, block) > leastWay;
}

std::vector<int> Falls::loosePieces(const std::vector<BlockMotion>& blocks) const {
    std::vector<int> loose;
    for (int row = 0; row < static_cast<int>(blocks.size()); ++row)
        if (!decides(row) && !blocks[row].absent && (falls(blocks, row) || hasLeft(blocks, row)))
            for (int cell = wholeOf(model_, row); cell < endOfWhole(model_, wholeOf(model_, row)); ++cell) loose.push_back(cell);
    return loose;
}

double Falls::moved(const std::vector<BlockMotion>& blocks, int block) const {
    const std::size_t at = block;
    return (blocks[at].centroid - places_[at]).norm() / sizes_[at];
}

}  // namespace keyblock
