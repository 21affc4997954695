// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/stage/falls.h"

#include <cmath>
#include <numeric>
#include <utility>

namespace keyblock {
namespace {

constexpr std::size_t remembered = 11;  // pseudo-steps over which a fall must not slow down
constexpr double steady = 0.95;  // of the acceleration at their beginning
constexpr double alike = 0.2;  // by which two accelerations may differ
constexpr double quick = 10.0;  // times what may be unbalanced at rest
constexpr double shortWay = 0.1, longWay = 0.5;  // of a block's size: after which a quick fall is believed, and any

}  // namespace

Falls::Falls(const Model& model, const std::vector<BlockMotion>& blocks, double share) : model_(model), share_(share) {
    for (const BlockMotion& block : blocks) places_.push_back(block.centroid);
    for (std::size_t rock = 0; rock + 1 < model.firstOf.size(); ++rock) {
        const auto first = model.blocks.begin() + model.firstOf[rock], end = model.blocks.begin() + model.firstOf[rock + 1];
        const double area = std::accumulate(first, end, 0.0, [](double sum, const BlockModel& b) { return sum + b.area; });
        sizes_.insert(sizes_.end(), static_cast<std::size_t>(end - first), std::sqrt(area));
    }
    for (std::size_t plate = sizes_.size(); plate < model.blocks.size(); ++plate) sizes_.push_back(model.blocks[plate].size);
}

void Falls::note(const std::vector<double>& moves, double dt, const std::vector<double>& own) {
    std::vector<double> accelerations;
    for (std::size_t i = 0; i < moves.size(); ++i)
        accelerations.push_back(model_.blocks[i].mass * 2.0 * moves[i] / (dt * dt) / own[i]);
    accelerations_.push_back(std::move(accelerations));
    if (accelerations_.size() > remembered) accelerations_.pop_front();
}

bool Falls::falls(const std::vector<BlockMotion>& blocks, int block) const {
    const auto at = static_cast<std::size_t>(block);
    if (accelerations_.size() < remembered || model_.blocks[at].plateOf >= 0) return false;
    const double now = accelerations_.back()[at], way = moved(blocks, block);
    if (now < steady * accelerations_.front()[at]) return false;
    return (now > quick * share_ && way > shortWay) || (now > share_ && way > longWay);
}

bool Falls::sameWhateverTheStep(int block) const {
    const auto at = static_cast<std::size_t>(block);
    const double now = accelerations_.back()[at], before = accelerations_[accelerations_.size() - 2][at];
    return std::abs(now - before) <= alike * before;
}

double Falls::moved(const std::vector<BlockMotion>& blocks, int block) const {
    const auto at = static_cast<std::size_t>(block);
    return (blocks[at].centroid - places_[at]).norm() / sizes_[at];
}

}  // namespace keyblock
