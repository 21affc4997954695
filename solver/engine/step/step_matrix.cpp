// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/step/step_matrix.h"

#include "solver/engine/step/trial.h"

#include <algorithm>
#include <cmath>

namespace keyblock {
namespace {

constexpr double sameBody = 1e-3;  // relative: a factor with bodies this close is kept

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

bool StepMatrix::keepsPattern(const StepProblem& problem, const std::vector<std::pair<int, int>>& pairs) const {
    return problem.known == known_ && static_cast<std::size_t>(problem.blocks) == blocks_.size() &&
           std::includes(pairs_.begin(), pairs_.end(), pairs.begin(), pairs.end());
}

void StepMatrix::begin(const StepProblem& problem, const LinkRows& rows) {
    exact_ = false;
    const bool sameLinks = links_.begin(problem, rows);
    if (!sameLinks || known_ != problem.known) {
        std::vector<std::pair<int, int>> pairs = bodyPairs(problem);
        if (!keepsPattern(problem, pairs)) fixPattern(problem, std::move(pairs));
        findLinkPairs(problem);
    }
    current_ = current_ && keepsBodies(problem);
}

void StepMatrix::findLinkPairs(const StepProblem& problem) {
    linkPairs_.clear();
    for (const Link& link : problem.links)
        linkPairs_.push_back({pairOf(link.a, link.a), link.b >= 0 ? pairOf(link.b, link.b) : -1,
                              link.b >= 0 ? pairOf(link.a, link.b) : -1});
}

bool StepMatrix::keepsBodies(const StepProblem& problem) const {
    const auto close = [](const auto& a, const auto& b) { return (a - b).norm() <= sameBody * b.norm(); };
    return std::equal(blocks_.begin(), blocks_.end(), problem.blockStiffness.begin(), problem.blockStiffness.end(), close) &&
           std::equal(nodes_.begin(), nodes_.end(), problem.nodeStiffness.begin(), problem.nodeStiffness.end(), close);
}

void StepMatrix::fixPattern(const StepProblem& problem, std::vector<std::pair<int, int>> pairs) {
    current_ = false;
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
    weights_.assign(weights.begin(), weights.end());
    if (current_ && update(rows, weights, work)) return -1;
    return factorInFull(problem, rows, weights, work);
}

int StepMatrix::factorInFull(const StepProblem& problem, const LinkRows& rows, std::span<const double> weights,
                             StepWork& work) {
    ++work.factorizations;
    ++work.fullFactorizations;
    assemble(problem, rows, weights);
    current_ = exact_ = false;
    if (const int loose = system_.factor(); loose >= 0) return unknownOf_[static_cast<std::size_t>(loose)];
    blocks_ = problem.blockStiffness;
    nodes_ = problem.nodeStiffness;
    links_.renew(rows, weights);
    current_ = exact_ = true;
    return -1;
}

/// \return false where that takes more than a full factor, or fails.
bool StepMatrix::update(const LinkRows& rows, std::span<const double> weights, StepWork& work) {
    const FactoredLinks::Changes changes = links_.changesTo(rows, weights);
    exact_ = exact_ && !changes.rounded;
    if (changes.count() == 0) return true;
    if (changes.count() > static_cast<std::size_t>(system_.worthwhileRanks())) return false;
    ++work.factorizations;
    work.ranks += static_cast<long>(changes.count());
    current_ = system_.addRanks(columnsOf(changes.add)) && system_.takeRanks(columnsOf(changes.take));
    if (current_) links_.change(rows, weights);
    return current_;
}

/// What a link adds to the matrix, c·cᵀ, by its column c.
std::vector<SparseColumn> StepMatrix::columnsOf(std::span<const FactoredLink> links) const {
    std::vector<SparseColumn> columns(links.size());
    for (std::size_t c = 0; c < links.size(); ++c) {
        const double root = std::sqrt(links[c].weight);
        const auto put = [&](int first, const double* entries) {
            for (int k = 0; k < 6; ++k)
                if (const int row = equations_[static_cast<std::size_t>(first + k)]; row >= 0 && entries[k] != 0.0)
                    columns[c].emplace_back(row, root * entries[k]);
        };
        put(links[c].firstA, links[c].gradient.data());
        put(links[c].firstB, links[c].gradient.data() + 6);
    }
    return columns;
}

Eigen::VectorXd StepMatrix::product(const StepProblem& problem, const LinkRows& rows, const Eigen::VectorXd& x,
                                    std::vector<double>& rates) const {
    rows.rates(x, rates);
    Eigen::VectorXd force = bodyProduct(problem, x);
    for (std::size_t i = 0; i < weights_.size(); ++i)
        if (weights_[i] > 0.0) rows.add(i, weights_[i] * rates[i], force.data());
    return force;
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
