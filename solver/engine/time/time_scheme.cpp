// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/time/time_scheme.h"

#include "solver/engine/step/phase.h"
#include "solver/engine/step/step_forces.h"
#include "solver/engine/time/mass.h"

#include <Eigen/Cholesky>

namespace keyblock {
namespace {

/// Chung and Hulbert's parameters, all derived from the spectral radius at infinite frequency.
SchemeFactors generalizedAlpha(double rho, double dt) {
    const double alphaM = (2.0 * rho - 1.0) / (rho + 1.0), alphaF = rho / (rho + 1.0);
    const double gamma = 0.5 - alphaM + alphaF, beta = 1.0 / ((rho + 1.0) * (rho + 1.0));
    const double end = 1.0 - alphaF;
    SchemeFactors f;
    f.inertia = {(1.0 - alphaM) / (beta * dt * dt), -(1.0 - alphaM) / (beta * dt), -0.5 * rho * (1.0 - rho)};
    f.velocity = {gamma / (beta * dt), 1.0 - gamma / beta, dt * (1.0 - 0.5 * gamma / beta)};
    f.acceleration = {1.0 / (beta * dt * dt), -1.0 / (beta * dt), 1.0 - 0.5 / beta};
    f.rate = {end * f.velocity.d, end * f.velocity.v + alphaF, end * f.velocity.a};
    f.rule = {ForceRule::Blend, end};
    f.elastic = f.loadTime = f.armTime = end;
    f.contactShare = 0.5 * (1.0 - alphaM) / beta;
    return f;
}

template <class Vector>
Vector combine(const Combination& c, const Vector& d, const Vector& v, const Vector& a) {
    return c.d * d + c.v * v + c.a * a;
}

void setVelocities(State& state, const Eigen::VectorXd& velocity) {
    Eigen::Index at = 0;
    for (BlockMotion& block : state.blocks) {
        block.velocity = velocity.segment<6>(at);
        at += 6;
    }
    for (BoltMotion& bolt : state.bolts)
        for (BoltNode& node : bolt.nodes) {
            node.velocity = velocity.segment<3>(at);
            at += 3;
        }
}

/// Blocks with a contact force at the start, at the end or over the step.
std::vector<char> pushedBlocks(const StepProblem& problem, const std::vector<double>& strains) {
    std::vector<char> pushed(problem.blocks, 0);
    for (std::size_t i = 0; i < strains.size(); ++i) {
        const Link& link = problem.links[i];
        if (link.kind != LinkKind::Normal) continue;
        if (respond(link.law, link.strain).force == 0.0 && respond(link.law, strains[i]).force == 0.0 &&
            respond(problem, link, strains[i]).force == 0.0)
            continue;
        pushed[link.a] = pushed[link.b] = 1;
    }
    return pushed;
}

/// Acceleration due to the forces over the step of those contacts that still act at its end.
Eigen::VectorXd lastingThrust(const Model& model, const StepProblem& problem, const std::vector<double>& strains) {
    Eigen::VectorXd push = Eigen::VectorXd::Zero(problem.unknowns());
    for (std::size_t i = 0; i < strains.size(); ++i) {
        const Link& link = problem.links[i];
        if (!ofContact(link.kind) || respond(link.law, strains[i]).force == 0.0) continue;
        const double force = link.law.share * respond(problem, link, strains[i]).force / problem.contactShare;
        push.segment<6>(problem.first(link.a)) -= force * link.ga;
        push.segment<6>(problem.first(link.b)) -= force * link.gb;
    }
    return byMass(model, problem, push);
}

/// Filters out the vibration after an impact of strains that are too stiff for the time step (theory, "Time").
void settleStrains(const Model& model, const StepProblem& problem, const Eigen::VectorXd& d, double dt,
                   Eigen::VectorXd& velocity, Eigen::VectorXd& acceleration) {
    std::vector<double> strains;
    linkStrains(problem, d, strains);
    const std::vector<char> pushed = pushedBlocks(problem, strains);
    const Eigen::VectorXd push = lastingThrust(model, problem, strains);
    for (std::size_t i = 0; i < pushed.size(); ++i) {
        const Eigen::Index spin = 6 * static_cast<Eigen::Index>(i) + 2;
        if (!pushed[i] || problem.known[spin + 1]) continue;
        const Matrix6& mass = model.blocks[i].massMatrix;
        const Eigen::Matrix3d own = mass.bottomRightCorner<3, 3>();
        const Eigen::Matrix3d stiff = dt * dt * model.blocks[i].area * model.thickness * model.blocks[i].elasticity;
        const Eigen::LDLT<Eigen::Matrix3d> both(own + stiff);
        const auto slow = [&](const Eigen::Vector3d& x) { return Eigen::Vector3d(both.solve(own * x)); };
        const Eigen::Vector3d rate = d.segment<3>(spin + 1) / dt, thrust = push.segment<3>(spin + 1);
        const Eigen::Vector3d change = rate + slow(velocity.segment<3>(spin + 1) - rate) - velocity.segment<3>(spin + 1);
        velocity.segment<3>(spin + 1) += change;
        if (!problem.known[spin] && mass(2, 2) > 0.0)  // conserves angular momentum
            velocity[spin] -= mass.block<1, 3>(2, 3).dot(change) / mass(2, 2);
        acceleration.segment<3>(spin + 1) = slow(acceleration.segment<3>(spin + 1) + thrust) - thrust;
    }
}

}  // namespace

SchemeFactors factorsOf(const StepOptions& options) {
    const double dt = options.dt;
    SchemeFactors f;
    f.rate = {1.0 / dt, 0.0, 0.0};
    switch (options.inertia) {
        case Inertia::None:
            f.rate = {0.0, 1.0, 0.0};
            break;
        case Inertia::Static:
            f.inertia = {2.0 / (dt * dt), 0.0, 0.0};
            break;
        case Inertia::BackwardEuler:
            f.inertia = {1.0 / (dt * dt), -1.0 / dt, 0.0};
            f.velocity = {1.0 / dt, 0.0, 0.0};
            break;
        case Inertia::Newmark:
            f.rule.rule = ForceRule::Average;
            f.elastic = f.loadTime = 0.5;
            [[fallthrough]];
        case Inertia::Shi:
            f.inertia = {2.0 / (dt * dt), -2.0 / dt, 0.0};
            f.velocity = {2.0 / dt, -1.0, 0.0};
            break;
        case Inertia::GeneralizedAlpha: return generalizedAlpha(options.rhoInf, dt);
    }
    return f;
}

StepMove moveOf(const StepOptions& options) {
    if (options.inertia == Inertia::None || options.inertia == Inertia::Static) return {};
    return {options.dt, factorsOf(options).armTime, options.path};
}

bool losesMotion(Inertia inertia) { return inertia == Inertia::BackwardEuler || inertia == Inertia::GeneralizedAlpha; }

bool carriesAccelerations(Inertia inertia) { return inertia == Inertia::GeneralizedAlpha; }

Eigen::VectorXd inertiaForce(const Model& model, const State& state, const SchemeFactors& factors,
                             const Eigen::VectorXd& d) {
    return timesMass(model, combine<Eigen::VectorXd>(factors.inertia, d, velocitiesOf(model, state),
                                                     accelerationsOf(model, state)));
}

void moveOn(const Model& model, State& state, const StepProblem& problem, const Eigen::VectorXd& d,
            const StepOptions& options) {
    const PhaseScope phase(Phase::Accept);
    const SchemeFactors factors = factorsOf(options);
    const Eigen::VectorXd before = velocitiesOf(model, state), acceleration = accelerationsOf(model, state);
    // with generalized-α, contacts contribute a velocity of their own, as in Newmark; accelerations exclude contact
    // forces
    Eigen::VectorXd push = Eigen::VectorXd::Zero(d.size()), kick = push;
    if (carriesAccelerations(options.inertia)) {
        push = contactForce(problem, d);
        kick = options.dt * byMass(model, problem, push);
    }
    const Eigen::VectorXd smooth = d - 0.5 * options.dt * kick;
    Eigen::VectorXd after = combine<Eigen::VectorXd>(factors.velocity, smooth, before, acceleration) + kick;
    Eigen::VectorXd next;
    if (carriesAccelerations(options.inertia)) {
        next = combine<Eigen::VectorXd>(factors.acceleration, smooth, before, acceleration);
        settleStrains(model, problem, d, options.dt, after, next);
    }
    for (Eigen::Index i = 0; i < d.size(); ++i)
        if (problem.known[i]) after[i] = d[i] / options.dt;
    // ½(v⁺ + v)·M·(v⁺ − v), row by row: kinetic energy gained by free and by driven unknowns
    const Eigen::VectorXd gained = 0.5 * (after + before).cwiseProduct(timesMass(model, after - before));
    for (Eigen::Index i = 0; i < d.size(); ++i)
        if (problem.known[i]) state.energy.external += gained[i];
    if (losesMotion(options.inertia)) {
        const Eigen::VectorXd inertia = inertiaForce(model, state, factors, smooth) + push;
        for (Eigen::Index i = 0; i < d.size(); ++i)
            if (!problem.known[i]) state.energy.damped += d[i] * inertia[i] - gained[i];
    }
    if (carriesAccelerations(options.inertia)) {
        state.acceleration.assign(next.data(), next.data() + next.size());
        for (std::size_t i = 0; i < problem.known.size(); ++i)
            if (problem.known[i]) state.acceleration[i] = 0.0;
    }
    setVelocities(state, after);
}

}  // namespace keyblock
