// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/step/dual_sweeps.h"

#include "solver/engine/step/anderson.h"
#include "solver/engine/step/friction_limits.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace keyblock {
namespace {

constexpr int mostSweeps = 36;
constexpr double settled = 1e-5;  // change of the forces in a sweep over the forces
constexpr int remembered = 6;  // sweeps that are mixed
constexpr double slides = 1.0 - 1e-9;  // of its limit
constexpr int limitCorrections = 2;  // of sliding forces, by the normal forces of the solution before
constexpr double leastHold = 1e-4;  // of a law's stiffness, where nothing else holds a body

/// Root of x + a·force(x) = free, which rises with slope 1 at least: Newton's steps, halved where they leave the bracket.
template <class ForceAt>
double rootOf(const ForceAt& forceAt, double a, double free, double x) {
    constexpr int mostSteps = 60;
    constexpr double nearRoot = 1e-7;  // of what the force moves
    double low = -std::numeric_limits<double>::infinity(), high = -low;
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

bool ofNode(const StepProblem& problem, const Link& link) {
    return link.a >= problem.blocks || link.b >= problem.blocks;
}

}  // namespace

DualSweeps::DualSweeps(StepProblem& problem, const LinkRows& rows, std::vector<double> carried)
    : problem_(problem), rows_(rows), force_(std::move(carried)), strain_(rows.count()) {
    findCompliances();
    findOrder();
    possible_ = possible_ && std::any_of(problem.links.begin(), problem.links.end(),
                                         [](const Link& link) { return ofContact(link.kind); });
    for (std::size_t i = 0; i < rows_.count(); ++i) strain_[i] = rows_.start(i);
}

std::vector<double> DualSweeps::carriedForces(const StepProblem& problem, const LinkRows& rows) {
    std::vector<double> forces(rows.count());
    for (std::size_t i = 0; i < rows.count(); ++i)
        forces[i] = respond(problem, problem.links[i], rows.start(i)).force;
    return forces;
}

void DualSweeps::findOrder() {
    std::vector<int> pairOf(rows_.count(), -1), follower(rows_.count(), -1);
    for (std::size_t p = 0; p < problem_.limitPairs.size(); ++p) {
        const LimitPair& pair = problem_.limitPairs[p];
        pairOf[static_cast<std::size_t>(pair.limited)] = static_cast<int>(p);
        follower[static_cast<std::size_t>(pair.from)] = pair.limited;
    }
    for (std::size_t i = 0; i < rows_.count(); ++i) {
        const Law& law = problem_.links[i].law;
        if (!swept_[i] || pairOf[i] >= 0 || (law.stiffness == 0.0 && law.kind != LawKind::Constant)) continue;
        order_.push_back({static_cast<int>(i), -1});
        if (const int next = follower[i]; next >= 0) order_.push_back({next, pairOf[static_cast<std::size_t>(next)]});
    }
}

void DualSweeps::findCompliances() {
    inverse_.resize(static_cast<std::size_t>(problem_.blocks));
    for (int b = 0; b < problem_.blocks; ++b) {
        Matrix6 own = problem_.blockStiffness[static_cast<std::size_t>(b)];
        Matrix6 free = Matrix6::Identity();
        for (int k = 0; k < 6; ++k)
            if (problem_.known[static_cast<std::size_t>(6 * b + k)]) free(k, k) = 0.0;
        own = free * own * free + (Matrix6::Identity() - free);
        const Eigen::LLT<Matrix6> factor(own);
        possible_ = possible_ && factor.info() == Eigen::Success;
        inverse_[static_cast<std::size_t>(b)] = free * factor.solve(free);
    }
    swept_.resize(rows_.count());
    yields_.assign(12 * rows_.count(), 0.0);
    compliance_.assign(rows_.count(), 0.0);
    for (std::size_t i = 0; i < rows_.count(); ++i) {
        const Link& link = problem_.links[i];
        swept_[i] = !ofNode(problem_, link);
        if (!swept_[i]) continue;
        const auto add = [&](int body, std::size_t at) {
            const Eigen::Map<const Vector6> g(rows_.gradient(i) + at);
            Eigen::Map<Vector6> y(&yields_[12 * i + at]);
            y.noalias() = inverse_[static_cast<std::size_t>(body)] * g;
            compliance_[i] += link.law.share * g.dot(y);
        };
        add(link.a, 0);
        if (link.b >= 0) add(link.b, 6);
    }
}

void DualSweeps::limit(int pair) {
    if (pair < 0) return;
    const LimitPair& p = problem_.limitPairs[static_cast<std::size_t>(pair)];
    setLimit(problem_, p, force_[static_cast<std::size_t>(p.from)]);
}

/// Displacement of the blocks under the present forces; nodes stay where they are.
void DualSweeps::place(Eigen::VectorXd& d) const {
    Eigen::VectorXd force = outer_;
    for (const Visit& visit : order_) {
        const auto i = static_cast<std::size_t>(visit.link);
        if (force_[i] != 0.0) rows_.add(i, -problem_.links[i].law.share * force_[i], force.data());
    }
    for (int b = 0; b < problem_.blocks; ++b) {
        d.segment<6>(6 * b).noalias() = inverse_[static_cast<std::size_t>(b)] * force.segment<6>(6 * b);
        for (int k = 6 * b; k < 6 * b + 6; ++k)
            if (problem_.known[static_cast<std::size_t>(k)]) d[k] = problem_.value[k];
    }
}

/// Force of a link that would be strained by `free` if it gave none.
double DualSweeps::settle(std::size_t i, double free) {
    const Link& link = problem_.links[i];
    const Law& law = link.law;
    const double a = compliance_[i];
    if (law.kind == LawKind::Constant) return respond(problem_, link, strain_[i]).force;
    const bool atEnd = ruleOf(problem_, link).rule == ForceRule::End && weightOf(link) == 1.0;
    if (!atEnd || law.kind == LawKind::Curve) {
        const auto forceAt = [&](double x) { return respond(problem_, link, x); };
        strain_[i] = rootOf(forceAt, a, free, free - a * force_[i]);
        return forceAt(strain_[i]).force;
    }
    double force = law.stiffness * (free - law.offset) / (1.0 + law.stiffness * a);
    if (law.kind == LawKind::Gap) force = std::min(0.0, force);
    if (law.kind == LawKind::Capped) force = std::clamp(force, -law.limit, law.limit);
    strain_[i] = free - a * force;
    return force;
}

DualSweeps::Change DualSweeps::sweep(Eigen::VectorXd& d) {
    Change sum;
    for (const Visit& visit : order_) {
        const auto i = static_cast<std::size_t>(visit.link);
        limit(visit.pair);
        const double free = rows_.start(i) + rows_.rate(i, d.data()) + compliance_[i] * force_[i];
        const double force = settle(i, free), more = force - force_[i];
        sum.changed += more * more;
        sum.forces += force * force;
        if (more == 0.0) continue;
        force_[i] = force;
        const double moves = -problem_.links[i].law.share * more, *y = &yields_[12 * i];
        double *a = d.data() + rows_.firstOfA(i), *b = d.data() + rows_.firstOfB(i);
        for (int k = 0; k < 6; ++k) a[k] += moves * y[k];
        for (int k = 0; k < 6; ++k) b[k] += moves * y[6 + k];
    }
    return sum;
}

/// Keeps mixed forces within what their laws can give.
void DualSweeps::clip(std::vector<double>& forces) {
    for (const Visit& visit : order_) {
        const auto i = static_cast<std::size_t>(visit.link);
        const Law& law = problem_.links[i].law;
        if (law.kind == LawKind::Gap) forces[i] = std::min(0.0, forces[i]);
        if (law.kind != LawKind::Capped) continue;
        if (visit.pair >= 0) {
            const LimitPair& pair = problem_.limitPairs[static_cast<std::size_t>(visit.pair)];
            setLimit(problem_, pair, forces[static_cast<std::size_t>(pair.from)]);
        }
        const double most = weightOf(problem_.links[i]) * law.limit;
        forces[i] = std::clamp(forces[i], -most, most);
    }
}

void DualSweeps::sweepUntilSettled(StepWork& work) {
    Eigen::VectorXd d = Eigen::VectorXd::Zero(problem_.unknowns() + LinkRows::padding);
    place(d);
    AndersonMixing mixing(remembered);
    for (int made = 1;; ++made) {
        const std::vector<double> before = force_;
        const Change sum = sweep(d);
        ++work.sweeps;
        if (!(sum.changed > settled * settled * sum.forces) || made == mostSweeps) return;
        if (!mixing.mix(before, force_)) continue;
        clip(force_);
        place(d);
        ++work.products;
    }
}

DualSweeps::Straight DualSweeps::straight(std::size_t i) const {
    const Link& link = problem_.links[i];
    const Law& law = link.law;
    const double most = weightOf(link) * law.limit;
    if (law.kind == LawKind::Capped && std::abs(force_[i]) >= slides * most)
        return {force_[i], 0.0, strain_[i], force_[i] > 0.0 ? 1.0 : -1.0};
    if (law.kind == LawKind::Gap && force_[i] == 0.0) return {0.0, 0.0, strain_[i], 0.0};
    return {force_[i], respond(problem_, link, strain_[i]).tangent, strain_[i], 0.0};
}

/// Links of bolt nodes give what they give at `from`; with the loads and prescribed moves that is what does not change
/// while the contact forces are swept.
void DualSweeps::holdTheRest(const Trial& from) {
    outer_ = padded(problem_.load);
    Eigen::VectorXd moves = Eigen::VectorXd::Zero(outer_.size());
    for (int i = 0; i < problem_.unknowns(); ++i)
        if (problem_.known[static_cast<std::size_t>(i)]) moves[i] = problem_.value[i];
    outer_ -= bodyProduct(problem_, moves);
    for (std::size_t i = 0; i < rows_.count(); ++i) {
        if (swept_[i]) continue;
        force_[i] = from.laws[i].force;
        strain_[i] = from.strains[i];
        rows_.add(i, -problem_.links[i].law.share * force_[i], outer_.data());
    }
}

/// Takes every law as straight in the state that its force says, and factors the matrix of that.
/// \return false where it is singular.
bool DualSweeps::straighten(const Trial& from, StepMatrix& matrix, StepWork& work) {
    laws_.resize(rows_.count());
    for (std::size_t i = 0; i < rows_.count(); ++i)
        laws_[i] = swept_[i] ? straight(i) : Straight{force_[i], from.laws[i].tangent, strain_[i], 0.0};
    const auto factored = [&](double least) {
        std::vector<double> weights(rows_.count());
        for (std::size_t i = 0; i < rows_.count(); ++i) {
            const Law& law = problem_.links[i].law;
            laws_[i].tangent = std::max(laws_[i].tangent, least * law.stiffness);
            weights[i] = law.share * laws_[i].tangent;
        }
        return matrix.factor(problem_, rows_, weights, work) < 0;
    };
    return factored(0.0) || factored(leastHold);
}

/// Forces of the straight laws at `strains`, kept within what the laws can give; what slides follows its limit.
void DualSweeps::takeForces(const std::vector<double>& strains) {
    for (std::size_t i = 0; i < rows_.count(); ++i) force_[i] = laws_[i].at(strains[i]);
    clip(force_);
    for (const Visit& visit : order_) {
        const auto i = static_cast<std::size_t>(visit.link);
        if (laws_[i].sliding == 0.0) continue;
        laws_[i].force = laws_[i].sliding * weightOf(problem_.links[i]) * problem_.links[i].law.limit;
        force_[i] = laws_[i].force;
    }
}

std::optional<Eigen::VectorXd> DualSweeps::solve(const Trial& from, StepMatrix& matrix, StepWork& work) {
    holdTheRest(from);
    sweepUntilSettled(work);
    if (!straighten(from, matrix, work)) return std::nullopt;
    Eigen::VectorXd d = from.d;
    std::vector<double> strains = from.strains;
    for (int correction = 0; correction <= limitCorrections; ++correction) {
        Eigen::VectorXd net = padded(problem_.load) - bodyProduct(problem_, d);
        for (std::size_t i = 0; i < rows_.count(); ++i)
            if (const double force = laws_[i].at(strains[i]); force != 0.0)
                rows_.add(i, -problem_.links[i].law.share * force, net.data());
        d += matrix.solve(net, work);
        rows_.strains(d, strains);
        work.products += 2;
        takeForces(strains);
    }
    return d;
}

}  // namespace keyblock
