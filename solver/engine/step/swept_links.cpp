// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/step/swept_links.h"

#include "solver/engine/step/friction_limits.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace keyblock {
namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();

/// Root of x + a·force(x) = free by Newton's method, with bisection if a step leaves the bracket. The left-hand side
/// increases with a slope of at least 1.
template <class ForceAt>
double rootOf(const ForceAt& forceAt, double a, double free, double x) {
    constexpr int mostSteps = 60;
    constexpr double nearRoot = 1e-7;  // fraction of the strain due to the force
    double low = -unlimited, high = unlimited;
    for (int step = 0; step < mostSteps; ++step) {
        const LawResponse r = forceAt(x);
        const double off = x + a * r.force - free;
        if (std::abs(off) <= nearRoot * a * std::abs(r.force)) return x;
        (off > 0.0 ? high : low) = x;
        double next = x - off / (1.0 + a * r.tangent);
        if (next <= low || next >= high) next = std::isinf(low) ? high - 1.0 : std::isinf(high) ? low + 1.0 : 0.5 * (low + high);
        if (std::abs(next - x) <= 1e-14 * std::max(std::abs(x), std::abs(free))) return next;
        x = next;
    }
    return x;
}

using GradientMap = Eigen::Map<const Eigen::Matrix<double, 12, 1>>;

bool ofNode(const StepProblem& problem, const Link& link) {
    return link.a >= problem.blocks || link.b >= problem.blocks;
}

double weightOf(const StepProblem& problem, const Link& link) {
    return ofContact(link.kind) ? problem.contactShare : 1.0;
}

}  // namespace

SweptLinks::SweptLinks(StepProblem& problem, const LinkRows& links)
    : problem_(problem), links_(links), nodes_(problem, links) {
    driven_ = Eigen::VectorXd::Zero(problem.unknowns() + LinkRows::padding);
    for (int i = 0; i < problem.unknowns(); ++i)
        if (problem.known[i]) driven_[i] = problem.value[i];
    scaleBlocks();
    std::vector<int> pairOf(links.count(), -1), follower(links.count(), -1);
    for (std::size_t p = 0; p < problem.limitPairs.size(); ++p) {
        const LimitPair& pair = problem.limitPairs[p];
        pairOf[pair.limited] = static_cast<int>(p);
        follower[pair.from] = pair.limited;
    }
    rows_.reserve(links.count());
    sources_.reserve(links.count());
    bounds_.reserve(links.count());
    for (std::size_t i = 0; i < links.count(); ++i) {
        const Law& law = problem.links[i].law;
        const bool weak = law.stiffness == 0.0 && law.kind != LawKind::Constant;
        if (ofNode(problem, problem.links[i]) || pairOf[i] >= 0 || weak) continue;
        addRow(i, -1);
        if (follower[i] < 0) continue;
        const std::size_t next = follower[i];
        addRow(next, pairOf[next]);
    }
    makeGroups();
    bentStrains_.assign(rows_.size(), 0.0);
    for (std::size_t n = 0; n < rows_.size(); ++n) bentStrains_[n] = sources_[n].start;
}

void SweptLinks::scaleBlocks() {
    scales_.resize(problem_.blocks);
    for (int b = 0; b < problem_.blocks; ++b) {
        Matrix6 free = Matrix6::Identity();
        for (int k = 0; k < 6; ++k)
            if (problem_.known[6 * b + k]) free(k, k) = 0.0;
        const Matrix6& stiffness = problem_.blockStiffness[b];
        const Eigen::LLT<Matrix6> factor(free * stiffness * free + (Matrix6::Identity() - free));
        possible_ = possible_ && factor.info() == Eigen::Success;
        scales_[b] = factor.matrixL().solve(free);
    }
}

void SweptLinks::addRow(std::size_t link, int pair) {
    const FlatLaw& law = links_.law(link);
    Row row;
    row.firstA = links_.firstOfA(link);
    row.firstB = problem_.links[link].b >= 0 ? links_.firstOfB(link) : 6 * problem_.blocks;
    row.share = problem_.links[link].law.share;
    scaleGradient(link, row);
    const double start = links_.start(link) + links_.rate(link, driven_.data());
    const double compliance = row.share * GradientMap(row.gradient.data()).squaredNorm();
    row.gain = law.stiffness / (1.0 + law.stiffness * compliance);
    row.base = row.gain * (start - law.offset);
    row.own = row.gain * compliance;
    rows_.push_back(row);
    sources_.push_back({start, compliance, law.stiffness, law.offset, pair, link});
    bounds_.push_back(law.bounds);
    bounds_.back().bent = law.bounds.bent || law.bounds.yields;
    if (law.bounds.follows) bounds_.back().low = -law.bounds.high;
}

/// Sets the scaled gradient of a row. The body with the smaller unknowns comes first, so that contacts of two bodies
/// can form a group, whichever of them has the corner.
void SweptLinks::scaleGradient(std::size_t n, Row& row) const {
    const Link& link = problem_.links[n];
    const auto scale = [&](int body, int at) {
        const Eigen::Map<const Vector6> gradient(links_.gradient(n) + at);
        Eigen::Map<Vector6>(row.gradient.data() + at).noalias() = scales_[body] * gradient;
    };
    scale(link.a, 0);
    if (link.b >= 0) scale(link.b, 6);
    if (row.firstA < row.firstB) return;
    std::swap(row.firstA, row.firstB);
    std::swap_ranges(row.gradient.begin(), row.gradient.begin() + 6, row.gradient.begin() + 6);
}

/// Divides the rows into groups, and finds how the rows of each affect each other.
void SweptLinks::makeGroups() {
    for (std::size_t n = 0; n < rows_.size(); ++n) {
        const bool continues = n > 0 && groups_.back().count < mostInGroup && rows_[n - 1].firstA == rows_[n].firstA &&
                               rows_[n - 1].firstB == rows_[n].firstB;
        if (!continues) groups_.push_back({n, 0});
        Group& group = groups_.back();
        ++group.count;
        group.bent = group.bent || bounds_[n].bent;
        const Eigen::Matrix<double, 12, 1> gradient = rows_[n].gain * GradientMap(rows_[n].gradient.data());
        for (std::size_t k = group.first; k < n; ++k)
            rows_[k].onNext[n - k - 1] = rows_[k].share * gradient.dot(GradientMap(rows_[k].gradient.data()));
    }
}

/// Range of a force whose law is a straight line between two limits. \param previous force of the row before it.
inline SweptLinks::Range SweptLinks::flatRange(std::size_t n, double previous) const {
    const FlatBounds& bounds = bounds_[n];
    const double pushed = -bounds.factor * previous;
    const double wider = pushed > 0.0 ? pushed : 0.0;
    return {bounds.low - wider, bounds.high + wider};
}

inline SweptLinks::Range SweptLinks::range(std::size_t n, const double* forces) const {
    return bounds_[n].bent ? bentRange(n, forces) : flatRange(n, n > 0 ? forces[n - 1] : 0.0);
}

SweptLinks::Range SweptLinks::bentRange(std::size_t n, const double* forces) const {
    const Source& source = sources_[n];
    if (source.pair >= 0) setLimit(problem_, problem_.limitPairs[source.pair], forces[n - 1]);
    const Link& link = problem_.links[source.link];
    const double most = weightOf(problem_, link) * link.law.limit;
    if (link.law.kind == LawKind::Capped) return {-most, most};
    return {-unlimited, link.law.kind == LawKind::Gap ? 0.0 : unlimited};
}

double SweptLinks::limit(std::size_t n, const std::vector<double>& forces) const {
    return range(n, forces.data()).high;
}

double SweptLinks::strain(std::size_t n, double force) const {
    const Source& source = sources_[n];
    if (bounds_[n].bent) return bentStrains_[n];
    return source.stiffness > 0.0 ? source.offset + force / source.stiffness : source.start;
}

double SweptLinks::tangent(std::size_t n) const {
    const Link& link = problem_.links[sources_[n].link];
    if (bounds_[n].bent) return respond(problem_, link, bentStrains_[n]).tangent;
    return link.law.kind == LawKind::Constant ? 0.0 : sources_[n].stiffness;
}

void SweptLinks::hold(const Eigen::VectorXd& outer, const Trial& from) {
    int chained = 0;
    for (std::size_t c = 0; c < nodes_.count(); ++c) chained += 6 * static_cast<int>(nodes_.blocks(c).size());
    held_ = Eigen::VectorXd::Zero(6 * problem_.blocks + LinkRows::padding + chained);
    for (int b = 0; b < problem_.blocks; ++b)
        held_.segment<6>(6 * b).noalias() = scales_[b] * outer.segment<6>(6 * b);
    holdChains(from);
}

/// Condenses the chains in scaled unknowns. They start with the forces that they have at the trial.
void SweptLinks::holdChains(const Trial& from) {
    chains_.clear();
    int first = 6 * problem_.blocks + LinkRows::padding;
    for (std::size_t c = 0; c < nodes_.count(); ++c) {
        const std::vector<int>& blocks = nodes_.blocks(c);
        const CondensedChain condensed = nodes_.condensed(c, from);
        const auto size = condensed.force.size();
        Eigen::MatrixXd scale = Eigen::MatrixXd::Zero(size, size);
        Eigen::VectorXd at(size);
        for (std::size_t k = 0; k < blocks.size(); ++k) {
            const int b = blocks[k];
            const auto row = 6 * static_cast<Eigen::Index>(k);
            scale.block<6, 6>(row, row) = scales_[b];
            const Vector6 free = from.d.segment<6>(6 * b) - driven_.segment<6>(6 * b);
            at.segment<6>(row) = scales_[b] * (problem_.blockStiffness[b] * free);
        }
        const Eigen::MatrixXd stiffness = scale * condensed.stiffness * scale.transpose();
        const Eigen::LDLT<Eigen::MatrixXd> factor(Eigen::MatrixXd::Identity(size, size) + stiffness);
        const Eigen::VectorXd force = scale * condensed.force;
        chains_.push_back({factor.solve(stiffness), factor.solve(force + stiffness * at), first});
        held_.segment(first, size) = force;
        for (std::size_t k = 0; k < blocks.size(); ++k) held_.segment<6>(6 * blocks[k]) += force.segment<6>(6 * k);
        first += static_cast<int>(size);
    }
}

/// Sets the force of each chain in turn, in equilibrium with the displacements that it causes.
void SweptLinks::sweepChains() {
    for (std::size_t c = 0; c < chains_.size(); ++c) {
        const Chain& chain = chains_[c];
        const std::vector<int>& blocks = nodes_.blocks(c);
        auto force = moved_.segment(chain.first, chain.force.size());
        without_.resize(chain.force.size());
        for (std::size_t k = 0; k < blocks.size(); ++k)
            without_.segment<6>(6 * k) = moved_.segment<6>(6 * blocks[k]) - force.segment<6>(6 * k);
        force = chain.force;
        force.noalias() -= chain.give * without_;
        for (std::size_t k = 0; k < blocks.size(); ++k)
            moved_.segment<6>(6 * blocks[k]) = without_.segment<6>(6 * k) + force.segment<6>(6 * k);
    }
}

Eigen::VectorXd SweptLinks::displacement() const {
    Eigen::VectorXd d = driven_;
    for (int b = 0; b < problem_.blocks; ++b)
        d.segment<6>(6 * b).noalias() += scales_[b].transpose() * moved_.segment<6>(6 * b);
    return d;
}

/// In equilibrium with its own effect on the strain, a force changes by only a part of the difference from its law.
double SweptLinks::mismatch(const Eigen::VectorXd& changes) const {
    double sum = 0.0;
    for (std::size_t n = 0; n < rows_.size(); ++n) {
        const double off = (1.0 + sources_[n].stiffness * sources_[n].compliance) *
                           changes[static_cast<Eigen::Index>(n)];
        sum += off * off;
    }
    return std::sqrt(sum);
}

void SweptLinks::clip(std::vector<double>& forces) {
    for (std::size_t n = 0; n < rows_.size(); ++n) {
        const Range within = range(n, forces.data());
        forces[n] = std::clamp(forces[n], within.low, within.high);
    }
}

/// Moves the two blocks of a row by the effect of a force on them.
inline void SweptLinks::move(const Row& row, double force) {
    const double moves = -row.share * force;
    Eigen::Map<Vector6>(moved_.data() + row.firstA) += moves * Eigen::Map<const Vector6>(row.gradient.data());
    Eigen::Map<Vector6>(moved_.data() + row.firstB) += moves * Eigen::Map<const Vector6>(row.gradient.data() + 6);
}

void SweptLinks::clipAndPlace(std::vector<double>& forces) {
    clip(forces);
    moved_ = held_;
    for (std::size_t n = 0; n < rows_.size(); ++n)
        if (forces[n] != 0.0) move(rows_[n], forces[n]);
}

/// Force of a link that would have the strain `free` without its own force.
double SweptLinks::bentForce(std::size_t n, double free, double force) {
    const Link& link = problem_.links[sources_[n].link];
    const auto forceAt = [&](double x) { return respond(problem_, link, x); };
    double& strain = bentStrains_[n];
    if (link.law.kind == LawKind::Constant) return forceAt(strain).force;
    const double compliance = sources_[n].compliance;
    strain = rootOf(forceAt, compliance, free, free - compliance * force);
    return forceAt(strain).force;
}

SweptLinks::Change SweptLinks::sweepBent(std::size_t n, double* forces, double* changes) {
    if (!bounds_[n].bent) return sweepGroup<1>(n, forces, changes);
    const Row& row = rows_[n];
    const Range within = bentRange(n, forces);
    const double before = forces[n];
    if (within.high == 0.0 && within.low == 0.0 && before == 0.0) {
        changes[n] = 0.0;
        return {};
    }
    const Eigen::Map<const Vector6> a(moved_.data() + row.firstA), b(moved_.data() + row.firstB);
    const GradientMap gradient(row.gradient.data());
    const double free = sources_[n].start + gradient.head<6>().dot(a) + gradient.tail<6>().dot(b) +
                        sources_[n].compliance * before;
    forces[n] = bentForce(n, free, before);
    changes[n] = forces[n] - before;
    move(row, changes[n]);
    const double changed = forces[n] - std::clamp(before, within.low, within.high);
    return {changed * changed, forces[n] * forces[n]};
}

/// Sweeps the rows of a group. The bodies move only after the last row; until then, the trial forces account for the
/// changes of the rows before.
template <int Count>
inline SweptLinks::Change SweptLinks::sweepGroup(std::size_t first, double* forces, double* changes) {
    const Row* rows = rows_.data() + first;
    Eigen::Map<Vector6> a(moved_.data() + rows->firstA), b(moved_.data() + rows->firstB);
    std::array<double, Count> trial, more;
#pragma GCC unroll 4
    for (int k = 0; k < Count; ++k) {
        const GradientMap gradient(rows[k].gradient.data());
        const double rate = (gradient.head<6>().cwiseProduct(a) + gradient.tail<6>().cwiseProduct(b)).sum();
        trial[k] = rows[k].base + rows[k].own * forces[first + k] + rows[k].gain * rate;
    }
    Change sum;
    double previous = first > 0 ? forces[first - 1] : 0.0;
#pragma GCC unroll 4
    for (int k = 0; k < Count; ++k) {
        const std::size_t n = first + k;
        const Range within = flatRange(n, previous);
        const double before = forces[n], force = clipped(trial[k], within.low, within.high);
        const double changed = force - clipped(before, within.low, within.high);
        sum.changed += changed * changed;
        sum.forces += force * force;
        previous = forces[n] = force;
        changes[n] = more[k] = force - before;
#pragma GCC unroll 4
        for (int next = k + 1; next < Count; ++next) trial[next] -= rows[k].onNext[next - k - 1] * more[k];
    }
    if (std::ranges::all_of(more, [](double x) { return x == 0.0; })) return sum;
    Vector6 movedA = a, movedB = b;
#pragma GCC unroll 4
    for (int k = 0; k < Count; ++k) {
        const double moves = rows[k].share * more[k];
        const GradientMap gradient(rows[k].gradient.data());
        movedA -= moves * gradient.head<6>();
        movedB -= moves * gradient.tail<6>();
    }
    a = movedA;
    b = movedB;
    return sum;
}

SweptLinks::Change SweptLinks::sweep(std::vector<double>& forces, Eigen::VectorXd& changes) {
    sweepChains();
    changes.resize(static_cast<Eigen::Index>(rows_.size()));
    Change sum;
    const auto add = [&](const Change& more) {
        sum.changed += more.changed;
        sum.forces += more.forces;
    };
    double *f = forces.data(), *c = changes.data();
    for (const Group& group : groups_) {
        if (group.bent) {
            for (int k = 0; k < group.count; ++k) add(sweepBent(group.first + k, f, c));
            continue;
        }
        switch (group.count) {
            case 1: add(sweepGroup<1>(group.first, f, c)); break;
            case 2: add(sweepGroup<2>(group.first, f, c)); break;
            case 3: add(sweepGroup<3>(group.first, f, c)); break;
            default: add(sweepGroup<mostInGroup>(group.first, f, c)); break;
        }
    }
    return sum;
}

}  // namespace keyblock
