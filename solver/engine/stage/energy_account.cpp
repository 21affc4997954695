// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/stage/energy_account.h"

#include "solver/engine/contact/candidates.h"
#include "solver/engine/contact/links.h"
#include "solver/engine/contact/springs.h"
#include "solver/engine/damping.h"
#include "solver/engine/stage/step_build.h"
#include "solver/engine/step/friction_limits.h"
#include "solver/engine/step/phase.h"
#include "solver/engine/step/step_forces.h"
#include "solver/engine/time/mass.h"

#include <algorithm>
#include <cmath>

namespace keyblock {
namespace {

bool known(const StepProblem& problem, Eigen::Index unknown) {
    return problem.known[unknown] != 0;
}

bool sameLink(const Link& a, const Link& b) { return a.kind == b.kind && a.owner == b.owner && a.part == b.part; }

/// True if a contact lasted from the start of a search to its end. If it ended on the way and formed again, it has
/// neither its force nor its zero point; what a contact takes over from others only increases both.
bool lasted(const Contact& start, const Contact& end) {
    return end.normalForce >= start.normalForce && end.gapOffset >= start.gapOffset;
}

/// The limits of the laws of all links of `problem`, in their order.
std::vector<double> limitsOf(const StepProblem& problem) {
    std::vector<double> limits;
    for (const Link& link : problem.links) limits.push_back(link.law.limit);
    return limits;
}

/// The link as it was when the search began. Forces from multipliers do not follow from the strain. A contact that
/// formed during the search may have been beyond the end of its edge at the start: it then had the force that it took
/// over there, or none. \param own the contact as accepted at the start; null if there was none or if it formed during
/// the search
PathStart startOf(const Model& model, const Link& link, const Link& first, double limit, const Contact* own,
                  const State& unaccepted) {
    if (!ofContact(link.kind)) return {first.strain, carriedForce(link.law, first.strain), limit};
    const bool met = !own;
    const Contact& c = unaccepted.contacts[link.owner];
    PathStart at{first.strain, carriedForce(link.law, first.strain), limit};
    if (link.law.rigid || met) at.force = link.kind == LinkKind::Normal ? -c.normalForce : c.shearForce;
    if (met) at.limit = std::max(0.0, c.normalForce) * frictionOf(model, c);
    if (link.kind == LinkKind::Friction && own && !own->bonded) {
        // an open contact was locked again at its present position; relative to it, the contact was sheared at the
        // start, but it never carried that force
        const double most = std::max(limit, std::abs(own->shearForce));
        at.force = own->normalForce <= 0.0 ? 0.0 : std::clamp(at.force, -most, most);
    }
    return at;
}

/// The limit of a hinge is determined again when a search begins. If it fell, the hinge still carries its previous
/// moment.
void carryHinges(StepProblem& problem) {
    for (Link& link : problem.links)
        if (link.kind == LinkKind::Bend || link.kind == LinkKind::Shear)
            link.law.limit = std::max(link.law.limit, std::abs(carriedForce(link.law, link.strain)));
}

/// If forces rise late, the loads do surplus work, which counts as damped. If forces rise early, more external work is
/// needed.
void addSurplus(double surplus, EnergyLedger& energy) {
    if (surplus > 0.0) energy.damped += surplus;
    else energy.external -= surplus;
}

/// Adds the difference between the work under the trapezium of a link's forces and the work that it stored and
/// dissipated. \return its mean force while it slid
double addLink(const Link& link, const PathStart& from, EnergyLedger& energy) {
    const PathWork path = pathWork(link.law, from, link.strain + link.shift);
    if (link.shift != 0.0)
        energy.external += 0.5 * link.law.share * link.shift *
                           (from.force + respond(link.law, link.strain + link.shift).force);
    addSurplus(path.surplus, energy);
    return path.slipForce;
}

/// True if a prescribed displacement is not zero.
bool isDriven(const StepProblem& problem, const Eigen::VectorXd& d) {
    for (Eigen::Index i = 0; i < d.size(); ++i)
        if (known(problem, i) && d[i] != 0.0) return true;
    return false;
}

/// Work of what drives prescribed unknowns against all forces. Its contribution to the motion is added with the
/// velocities. \param strains strains of the links at the end of the step.
double drivingWork(const Model& model, const State& state, const StepProblem& problem, const Eigen::VectorXd& d,
                   const std::vector<double>& strains, const SchemeFactors& factors) {
    Eigen::VectorXd driven = netForce(problem, d, strains) + inertiaForce(model, state, factors, d);
    if (problem.contactShare != 1.0) driven -= (problem.contactShare - 1.0) * contactForce(problem, d);
    double work = 0.0;
    for (Eigen::Index i = 0; i < d.size(); ++i)
        if (known(problem, i)) work -= driven[i] * d[i];
    return work;
}

}  // namespace

void accountStep(const Model& model, State& state, const StepProblem& problem, const Eigen::VectorXd& external,
              const Eigen::VectorXd& d, const StepOptions& options) {
    const PhaseScope phase(Phase::Accept);
    const SchemeFactors factors = factorsOf(options);
    std::vector<double> after;
    linkStrains(problem, d, after);
    state.energy.external += external.dot(d);
    if (isDriven(problem, d)) state.energy.external += drivingWork(model, state, problem, d, after, factors);
    for (std::size_t i = 0; i < after.size(); ++i) {
        const Link& link = problem.links[i];
        state.energy.damped += lawLoss(link.law, link.strain, after[i], ruleOf(problem, link));
        if (link.shift == 0.0) continue;
        const double force = respondOverStep(link.law, link.strain, after[i], ruleOf(problem, link)).force;
        const double shifted = link.law.share * force * link.shift;
        if (ofContact(link.kind)) state.energy.external += shifted;  // work of dilation
        else state.energy.damped -= shifted;  // the part of a rotation that g·D misses; it moved no body
    }
    for (std::size_t i = 0; i < model.blocks.size(); ++i) {
        const Eigen::Vector3d strain = d.segment<3>(6 * static_cast<Eigen::Index>(i) + 3);
        state.energy.damped += (factors.elastic - 0.5) * model.blocks[i].area * model.thickness *
                               strain.dot(model.blocks[i].elasticity * strain);
    }
    if (options.damping != Damping{}) state.energy.damped += dampedWork(model, state, options, d);
}

StaticAccount::StaticAccount(const Model& model, const State& start, const Loads& loads, const LoadPoint& before)
    : model_(model), loads_(loads), before_(before), start_(start) {
    StepProblem problem = buildStep(model, start, loads, before, {Inertia::None});
    carryHinges(problem);
    first_ = forcesOf(problem, start, before);
}

StaticAccount::Forces StaticAccount::forcesOf(StepProblem& problem, const State& state, const LoadPoint& at) const {
    const Eigen::VectorXd still = Eigen::VectorXd::Zero(problem.unknowns());
    correctFrictionLimits(problem, still);
    double total = 0.0;
    return {externalForce(model_, state, loads_, at, {}, total), netForce(problem, still)};
}

/// The links at the end of the path, with the state at its start.
StepProblem StaticAccount::atStart(const State& end) const {
    State start = start_;
    start.contacts = end.contacts;
    StepProblem problem = buildStep(model_, start, loads_, before_, {Inertia::None});
    carryHinges(problem);
    correctFrictionLimits(problem, Eigen::VectorXd::Zero(problem.unknowns()));
    return problem;
}

const Contact* StaticAccount::contactAtStart(const Link& link, const State& end) const {
    if (!ofContact(link.kind)) return nullptr;
    const Contact& now = end.contacts[link.owner];
    const Contact* own = sameContact(start_.contacts, now);
    return own && lasted(*own, now) ? own : nullptr;
}

/// Work of contacts that have ended: half of their force at the start times their displacement [J].
double StaticAccount::trapeziumOfEnded(const State& end, const Eigen::VectorXd& moved) const {
    StepProblem problem = stepForLinks(model_);
    addContactLinks(model_, start_, false, problem);
    correctFrictionLimits(problem, Eigen::VectorXd::Zero(problem.unknowns()));
    double sum = 0.0;
    for (const Link& link : problem.links) {
        const Contact& c = start_.contacts[link.owner];
        if (const Contact* now = sameContact(end.contacts, c); now && lasted(c, *now)) continue;
        const double way = link.ga.dot(moved.segment<6>(6 * link.a)) + link.gb.dot(moved.segment<6>(6 * link.b));
        const double shear = link.law.rigid ? c.shearForce : std::clamp(c.shearForce, -link.law.limit, link.law.limit);
        sum += 0.5 * (link.kind == LinkKind::Normal ? -c.normalForce : shear) * way;
    }
    return sum;
}

void StaticAccount::addBodies(EnergyLedger& energy, const Forces& last, const Eigen::VectorXd& moved,
                              const StepProblem& problem) const {
    for (Eigen::Index i = 0; i < moved.size(); ++i) {
        energy.external += 0.5 * (first_.external[i] + last.external[i]) * moved[i];
        if (known(problem, i)) energy.external -= 0.5 * (first_.net[i] + last.net[i]) * moved[i];
        else energy.damped += 0.5 * (first_.net[i] + last.net[i]) * moved[i];
    }
}

void StaticAccount::add(State& end, const LoadPoint& at, const Eigen::VectorXd& moved, StepProblem& problem) const {
    addBodies(end.energy, forcesOf(problem, end, at), moved, problem);
    const StepProblem start = atStart(end);
    const std::vector<double> startLimits = limitsOf(start);
    problem.slipForce.assign(problem.links.size(), 0.0);
    double handed = trapeziumOfEnded(end, moved);
    std::size_t s = 0;
    for (std::size_t i = 0; i < problem.links.size(); ++i) {
        const Link& link = problem.links[i];
        if (link.kind == LinkKind::Chord) continue;
        while (!sameLink(start.links.at(s), link)) ++s;  // except for chords, the links are the same, in the same order
        const Contact* own = contactAtStart(link, end);
        const PathStart from = startOf(model_, link, start.links[s], startLimits[s], own, end);
        problem.slipForce[i] = addLink(link, from, end.energy);
        if (ofContact(link.kind) && !own)  // the net force at the start did not include it
            handed -= 0.5 * link.law.share * from.force * (link.strain - from.strain);
        ++s;
    }
    addSurplus(handed, end.energy);
}

}  // namespace keyblock
