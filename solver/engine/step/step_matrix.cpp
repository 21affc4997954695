// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/step/step_matrix.h"

#include <algorithm>
#include <cmath>

namespace keyblock {
namespace {

constexpr double sameWeight = 1e-9;  // relative: so near to each other two weights are one

std::vector<std::pair<int, int>> bodyPairs(const StepProblem& problem) {
    std::vector<std::pair<int, int>> pairs;
    pairs.reserve(static_cast<std::size_t>(problem.blocks + problem.nodes) + problem.links.size());
    for (int body = 0; body < problem.blocks + problem.nodes; ++body) pairs.emplace_back(body, body);
    for (const Link& link : problem.links)
        if (link.b >= 0) pairs.emplace_back(std::max(link.a, link.b), std::min(link.a, link.b));
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    return pairs;
}

/// Adds w·p·qᵀ to the 6 × 6 entries of a pair.
template <class Slots>
void addOuter(double w, const double* p, const double* q, const Slots& slots, std::span<double> values) {
    for (int i = 0; i < 6; ++i) {
        const double wp = w * p[i];
        if (wp == 0.0) continue;
        for (int j = 0; j < 6; ++j)
            if (const int slot = slots[static_cast<std::size_t>(6 * i + j)]; slot >= 0)
                values[static_cast<std::size_t>(slot)] += wp * q[j];
    }
}

}  // namespace

int StepMatrix::pairOf(int first, int second) const {
    const auto found = std::lower_bound(pairs_.begin(), pairs_.end(),
                                        std::pair(std::max(first, second), std::min(first, second)));
    return static_cast<int>(found - pairs_.begin());
}

void StepMatrix::begin(const StepProblem& problem, const LinkRows& rows) {
    std::vector<std::pair<int, int>> pairs = bodyPairs(problem);
    const bool same = problem.known == known_ &&
                      std::includes(pairs_.begin(), pairs_.end(), pairs.begin(), pairs.end());
    if (!same) fixPattern(problem, std::move(pairs));
    current_ = false;
    linkPairs_.resize(rows.count());
    for (std::size_t i = 0; i < rows.count(); ++i) {
        const Link& link = problem.links[i];
        linkPairs_[i] = {pairOf(link.a, link.a), link.b >= 0 ? pairOf(link.b, link.b) : -1,
                         link.b >= 0 ? pairOf(link.a, link.b) : -1};
    }
}

void StepMatrix::fixPattern(const StepProblem& problem, std::vector<std::pair<int, int>> pairs) {
    known_ = problem.known;
    pairs_ = std::move(pairs);
    equations_.assign(static_cast<std::size_t>(problem.unknowns() + LinkRows::padding), -1);
    unknownOf_.clear();
    for (int i = 0; i < problem.unknowns(); ++i) {
        if (known_[static_cast<std::size_t>(i)]) continue;
        equations_[static_cast<std::size_t>(i)] = static_cast<int>(unknownOf_.size());
        unknownOf_.push_back(i);
    }
    findSlots(problem);
    right_.resize(unknownOf_.size());
    left_.resize(unknownOf_.size());
}

void StepMatrix::findSlots(const StepProblem& problem) {
    const auto eachEntry = [&](const std::pair<int, int>& pair, const auto& visit) {
        for (int i = 0; i < problem.width(pair.first); ++i)
            for (int j = 0; j < problem.width(pair.second); ++j) {
                const int row = equations_[static_cast<std::size_t>(problem.first(pair.first) + i)];
                const int col = equations_[static_cast<std::size_t>(problem.first(pair.second) + j)];
                if (row >= 0 && col >= 0 && row >= col) visit(6 * i + j, row, col);
            }
    };
    std::vector<std::pair<int, int>> entries;
    for (const auto& pair : pairs_)
        eachEntry(pair, [&](int, int row, int col) { entries.emplace_back(row, col); });
    system_.analyse(static_cast<int>(unknownOf_.size()), entries);
    slots_.assign(pairs_.size(), {});
    for (std::size_t p = 0; p < pairs_.size(); ++p) {
        slots_[p].fill(-1);
        eachEntry(pairs_[p], [&](int at, int row, int col) {
            slots_[p][static_cast<std::size_t>(at)] = system_.slot(row, col);
        });
    }
}

void StepMatrix::assemble(const StepProblem& problem, const LinkRows& rows, std::span<const double> weights) {
    system_.clear();
    const auto values = system_.values();
    const auto addOwn = [&](int body, const auto& block) {
        const Slots& slots = slots_[static_cast<std::size_t>(pairOf(body, body))];
        for (int i = 0; i < block.rows(); ++i)
            for (int j = 0; j < block.cols(); ++j)
                if (const int slot = slots[static_cast<std::size_t>(6 * i + j)]; slot >= 0)
                    values[static_cast<std::size_t>(slot)] += block(i, j);
    };
    for (int i = 0; i < problem.blocks; ++i) addOwn(i, problem.blockStiffness[static_cast<std::size_t>(i)]);
    for (int i = 0; i < problem.nodes; ++i)
        addOwn(problem.blocks + i, Eigen::Matrix3d(problem.nodeStiffness[static_cast<std::size_t>(i)].asDiagonal()));
    for (std::size_t i = 0; i < weights.size(); ++i) {
        if (weights[i] == 0.0) continue;
        const double *ga = rows.gradient(i), *gb = ga + 6;
        const auto& [a, b, both] = linkPairs_[i];
        addOuter(weights[i], ga, ga, slots_[static_cast<std::size_t>(a)], values);
        if (b < 0) continue;
        addOuter(weights[i], gb, gb, slots_[static_cast<std::size_t>(b)], values);
        const bool aFirst = problem.links[i].a >= problem.links[i].b;
        addOuter(weights[i], aFirst ? ga : gb, aFirst ? gb : ga, slots_[static_cast<std::size_t>(both)], values);
    }
}

int StepMatrix::factor(const StepProblem& problem, const LinkRows& rows, std::span<const double> weights,
                       StepWork& work) {
    if (current_ && std::equal(weights.begin(), weights.end(), inFactor_.begin(), inFactor_.end())) return -1;
    ++work.factorizations;
    if (update(rows, weights, work)) return -1;
    return factorInFull(problem, rows, weights, work);
}

int StepMatrix::factorInFull(const StepProblem& problem, const LinkRows& rows, std::span<const double> weights,
                             StepWork& work) {
    ++work.fullFactorizations;
    assemble(problem, rows, weights);
    current_ = false;
    if (const int loose = system_.factor(); loose >= 0) return unknownOf_[static_cast<std::size_t>(loose)];
    inFactor_.assign(weights.begin(), weights.end());
    current_ = true;
    return -1;
}

bool StepMatrix::update(const LinkRows& rows, std::span<const double> weights, StepWork& work) {
    if (!current_) return false;
    std::vector<int> stiffer, softer;
    std::vector<double> more, less;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        const double change = weights[i] - inFactor_[i];
        if (std::abs(change) <= sameWeight * std::max(weights[i], inFactor_[i])) continue;
        (change > 0.0 ? stiffer : softer).push_back(static_cast<int>(i));
        (change > 0.0 ? more : less).push_back(std::abs(change));
    }
    const std::size_t ranks = stiffer.size() + softer.size();
    if (ranks > static_cast<std::size_t>(system_.worthwhileRanks())) return false;
    work.ranks += static_cast<long>(ranks);
    const bool done = system_.addRanks(columnsOf(rows, stiffer, more)) &&
                      system_.takeRanks(columnsOf(rows, softer, less));
    current_ = done;
    if (done) inFactor_.assign(weights.begin(), weights.end());
    return done;
}

std::vector<SparseColumn> StepMatrix::columnsOf(const LinkRows& rows, std::span<const int> links,
                                                std::span<const double> changes) const {
    std::vector<SparseColumn> columns(links.size());
    for (std::size_t c = 0; c < links.size(); ++c) {
        const auto i = static_cast<std::size_t>(links[c]);
        const double root = std::sqrt(changes[c]), *g = rows.gradient(i);
        const auto put = [&](int first, const double* entries) {
            for (int k = 0; k < 6; ++k)
                if (const int row = equations_[static_cast<std::size_t>(first + k)]; row >= 0 && entries[k] != 0.0)
                    columns[c].emplace_back(row, root * entries[k]);
        };
        put(rows.firstOfA(i), g);
        put(rows.firstOfB(i), g + 6);
    }
    return columns;
}

Eigen::VectorXd StepMatrix::solve(const Eigen::VectorXd& force, StepWork& work) {
    ++work.solves;
    for (std::size_t i = 0; i < right_.size(); ++i) right_[i] = force[unknownOf_[i]];
    system_.solve(right_, left_);
    Eigen::VectorXd x = Eigen::VectorXd::Zero(force.size());
    for (std::size_t i = 0; i < left_.size(); ++i) x[unknownOf_[i]] = left_[i];
    return x;
}

}  // namespace keyblock
