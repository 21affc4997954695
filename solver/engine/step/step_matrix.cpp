// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/step/step_matrix.h"

#include "solver/engine/step/nested_dissection.h"
#include "solver/engine/step/phase.h"
#include "solver/engine/step/trial.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace keyblock {
namespace {

constexpr double sameBody = 1e-3;  // relative change of a body's stiffness up to which a factor is kept
constexpr std::size_t dissectedFrom = 4000;  // number of bodies with equations from which nested dissection is tried
constexpr double mostIdle = 0.1;  // fraction of the equations that may belong to nodes of lost or removed bolts

std::vector<std::pair<int, int>> bodyPairs(const StepProblem& problem) {
    std::vector<std::pair<int, int>> pairs;
    pairs.reserve(static_cast<std::size_t>(problem.blocks + problem.nodes) + problem.links.size());
    for (int body = 0; body < problem.blocks + problem.nodes; ++body) pairs.emplace_back(body, body);
    for (const Link& link : problem.links) {
        const std::pair pair(std::max(link.a, link.b), std::min(link.a, link.b));
        // links between the same two bodies are adjacent
        if (link.b >= 0 && pair != pairs.back()) pairs.push_back(pair);
    }
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    return pairs;
}

template <int Height, int Width>
void addProductOf(Matrix6& sum, double weight, const double* left, const double* right) {
    using Left = Eigen::Matrix<double, Height, 1>;
    using Right = Eigen::Matrix<double, Width, 1>;
    const Left weighted = weight * Eigen::Map<const Left>(left);
    sum.topLeftCorner<Height, Width>().noalias() += weighted * Eigen::Map<const Right>(right).transpose();
}

/// Adds `weight`·left·rightᵀ to the entries of two bodies, of which a bolt node has only three unknowns.
void addProduct(Matrix6& sum, double weight, const double* left, bool leftIsBlock, const double* right,
                bool rightIsBlock) {
    if (leftIsBlock && rightIsBlock) addProductOf<6, 6>(sum, weight, left, right);
    else if (leftIsBlock) addProductOf<6, 3>(sum, weight, left, right);
    else if (rightIsBlock) addProductOf<3, 6>(sum, weight, left, right);
    else addProductOf<3, 3>(sum, weight, left, right);
}

}  // namespace

std::vector<int> eliminationGroups(const StepProblem& problem) {
    if (problem.places.size() < dissectedFrom) return {};
    std::vector<int> rowOf(problem.blocks + problem.nodes, -1);  // among the bodies that have an equation
    std::vector<Eigen::Vector2d> places;
    for (int body = 0; body < problem.blocks + problem.nodes; ++body) {
        const auto first = problem.known.begin() + problem.first(body);
        if (std::all_of(first, first + problem.width(body), [](char known) { return known != 0; })) continue;
        rowOf[body] = static_cast<int>(places.size());
        places.push_back(problem.places[body]);
    }
    if (places.size() < dissectedFrom) return {};
    std::vector<std::pair<int, int>> pairs;
    for (const auto& [a, b] : bodyPairs(problem))
        if (rowOf[a] >= 0 && rowOf[b] >= 0) pairs.emplace_back(rowOf[a], rowOf[b]);
    const std::vector<int> ofRow = nestedDissection(places, pairs);
    std::vector<int> groups;
    for (int body = 0; body < problem.blocks + problem.nodes; ++body)
        for (int i = problem.first(body); i < problem.first(body) + problem.width(body); ++i)
            if (!problem.known[i]) groups.push_back(ofRow[rowOf[body]]);
    return groups;
}

int StepMatrix::pairOf(int a, int b) const {
    const auto [second, first] = std::minmax(a, b);
    const auto begin = pairs_.begin() + (first > 0 ? own_[first - 1] + 1 : 0);
    const auto end = pairs_.begin() + own_[first] + 1;
    return static_cast<int>(std::lower_bound(begin, end, std::pair(first, second)) - pairs_.begin());
}

bool StepMatrix::keepsPattern(const StepProblem& problem, const std::vector<std::pair<int, int>>& pairs) const {
    return static_cast<std::size_t>(problem.blocks) == blocks_.size() && keepsUnknowns(problem) &&
           std::includes(pairs_.begin(), pairs_.end(), pairs.begin(), pairs.end());
}

/// Whether the step has the unknowns of the pattern. Nodes of bolts that were lost or removed after the pattern was fixed
/// may keep their equations, because no link acts on them.
bool StepMatrix::keepsUnknowns(const StepProblem& problem) const {
    if (patternKnown_ == problem.known) return true;
    if (patternKnown_.size() != problem.known.size()) return false;
    std::vector<char> isIdle(problem.nodes, 0);
    std::size_t count = 0;
    for (int i = 0; i < problem.unknowns(); ++i) {
        if (patternKnown_[i] == problem.known[i]) continue;
        const int node = (i - 6 * problem.blocks) / 3;
        if (patternKnown_[i] || i < 6 * problem.blocks || !(problem.nodeStiffness[node].minCoeff() > 0.0)) return false;
        isIdle[node] = 1;
        ++count;
    }
    const auto ofIdle = [&](int body) { return body >= problem.blocks && isIdle[body - problem.blocks]; };
    return static_cast<double>(count) <= mostIdle * static_cast<double>(unknownOf_.size()) &&
           std::none_of(problem.links.begin(), problem.links.end(),
                        [&](const Link& link) { return ofIdle(link.a) || ofIdle(link.b); });
}

/// Lists the equations of unknowns that are prescribed in this step.
void StepMatrix::findIdle(const StepProblem& problem) {
    known_ = problem.known;
    idle_.clear();
    for (std::size_t e = 0; e < unknownOf_.size(); ++e)
        if (known_[unknownOf_[e]]) idle_.push_back(static_cast<int>(e));
}

void StepMatrix::begin(const StepProblem& problem, const LinkRows& rows) {
    const PhaseScope phase(Phase::Build);
    exact_ = false;
    const bool sameLinks = links_.begin(problem, rows);
    if (!sameLinks || known_ != problem.known) {
        std::vector<std::pair<int, int>> pairs = bodyPairs(problem);
        if (!keepsPattern(problem, pairs)) fixPattern(problem, std::move(pairs));
        findLinkPairs(problem);
        findIdle(problem);
    }
    current_ = current_ && keepsBodies(problem);
}

void StepMatrix::findLinkPairs(const StepProblem& problem) {
    linkPairs_.clear();
    for (const Link& link : problem.links) linkPairs_.push_back(link.b >= 0 ? pairOf(link.a, link.b) : -1);
}

bool StepMatrix::keepsBodies(const StepProblem& problem) const {
    const auto close = [](const auto& a, const auto& b) { return (a - b).norm() <= sameBody * b.norm(); };
    return std::equal(blocks_.begin(), blocks_.end(), problem.blockStiffness.begin(), problem.blockStiffness.end(), close) &&
           std::equal(nodes_.begin(), nodes_.end(), problem.nodeStiffness.begin(), problem.nodeStiffness.end(), close);
}

void StepMatrix::fixPattern(const StepProblem& problem, std::vector<std::pair<int, int>> pairs) {
    current_ = false;
    patternKnown_ = problem.known;
    pairs_ = std::move(pairs);
    own_.clear();
    for (std::size_t p = 0; p < pairs_.size(); ++p)
        if (pairs_[p].first == pairs_[p].second) own_.push_back(static_cast<int>(p));
    equations_.assign(problem.unknowns() + LinkRows::padding, -1);
    unknownOf_.clear();
    for (int i = 0; i < problem.unknowns(); ++i) {
        if (patternKnown_[i]) continue;
        equations_[i] = static_cast<int>(unknownOf_.size());
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
                const int row = equations_[problem.first(pair.first) + i];
                const int col = equations_[problem.first(pair.second) + j];
                if (row >= 0 && col >= 0 && row >= col) visit(i + 6 * j, row, col);
            }
    };
    std::vector<std::pair<int, int>> entries;
    for (const auto& pair : pairs_)
        eachEntry(pair, [&](int, int row, int col) { entries.emplace_back(row, col); });
    system_.analyse(static_cast<int>(unknownOf_.size()), entries, eliminationGroups(problem));
    slots_.assign(pairs_.size(), {});
    for (std::size_t p = 0; p < pairs_.size(); ++p) {
        slots_[p].fill(-1);
        eachEntry(pairs_[p], [&](int at, int row, int col) {
            slots_[p][at] = system_.slot(row, col);
        });
    }
}

/// Adds up the links pair by pair first, so that the sparse matrix is traversed only once and not for every link.
void StepMatrix::assemble(const StepProblem& problem, const LinkRows& rows, std::span<const double> weights) {
    const PhaseScope phase(Phase::Assemble);
    sums_.assign(pairs_.size(), Matrix6::Zero());
    const auto sumOf = [&](int pair) -> Matrix6& { return sums_[pair]; };
    const auto ownSum = [&](int body) -> Matrix6& { return sumOf(own_[body]); };
    for (int i = 0; i < problem.blocks; ++i) ownSum(i) = problem.blockStiffness[i];
    for (int i = 0; i < problem.nodes; ++i)
        ownSum(problem.blocks + i).diagonal().head<3>() = problem.nodeStiffness[i];
    for (std::size_t i = 0; i < weights.size(); ++i) {
        if (weights[i] == 0.0) continue;
        const int a = rows.bodyA(i), b = rows.bodyB(i);
        const double *ga = rows.gradient(i), *gb = ga + 6;
        const bool blockA = a < problem.blocks, blockB = b < problem.blocks;
        addProduct(ownSum(a), weights[i], ga, blockA, ga, blockA);
        if (b < 0) continue;
        addProduct(ownSum(b), weights[i], gb, blockB, gb, blockB);
        if (a >= b) addProduct(sumOf(linkPairs_[i]), weights[i], ga, blockA, gb, blockB);
        else addProduct(sumOf(linkPairs_[i]), weights[i], gb, blockB, ga, blockA);
    }
    const auto values = system_.values();
    for (std::size_t p = 0; p < pairs_.size(); ++p) {
        const int height = problem.width(pairs_[p].first), width = problem.width(pairs_[p].second);
        for (int column = 0; column < width; ++column)
            for (int row = 0; row < height; ++row)
                if (const int slot = slots_[p][row + 6 * column]; slot >= 0) values[slot] = sums_[p](row, column);
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
    const PhaseScope phase(Phase::Factor);
    ++work.factorizations;
    ++work.fullFactorizations;
    assemble(problem, rows, weights);
    current_ = exact_ = false;
    if (const int loose = system_.factor(); loose >= 0) return unknownOf_[loose];
    blocks_ = problem.blockStiffness;
    nodes_ = problem.nodeStiffness;
    links_.renew(rows, weights);
    current_ = exact_ = true;
    return -1;
}

/// \return false if an update costs more than a full factorisation, or fails.
bool StepMatrix::update(const LinkRows& rows, std::span<const double> weights, StepWork& work) {
    const PhaseScope phase(Phase::Update);
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

/// Columns c of the contributions c·cᵀ of the links to the matrix.
std::vector<SparseColumn> StepMatrix::columnsOf(std::span<const FactoredLink> links) const {
    std::vector<SparseColumn> columns(links.size());
    for (std::size_t c = 0; c < links.size(); ++c) {
        const double root = std::sqrt(links[c].weight);
        const auto put = [&](int first, const double* entries) {
            for (int k = 0; k < 6; ++k)
                if (const int row = equations_[first + k]; row >= 0 && entries[k] != 0.0)
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
    const PhaseScope phase(Phase::Solve);
    assert(current_);
    ++work.solves;
    for (std::size_t i = 0; i < right_.size(); ++i) right_[i] = force[unknownOf_[i]];
    for (const int idle : idle_) right_[idle] = 0.0;
    system_.solve(right_, left_);
    for (const int idle : idle_) left_[idle] = 0.0;  // round-off of the updates that removed their links
    Eigen::VectorXd x = Eigen::VectorXd::Zero(force.size());
    for (std::size_t i = 0; i < left_.size(); ++i) x[unknownOf_[i]] = left_[i];
    return x;
}

}  // namespace keyblock
