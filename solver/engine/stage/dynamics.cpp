// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/stage/dynamics.h"

#include "solver/engine/bolt/topology.h"
#include "solver/engine/contact/joint.h"
#include "solver/engine/contact/search.h"
#include "solver/engine/contact/springs.h"
#include "solver/engine/glue.h"
#include "solver/engine/stage/energy_account.h"
#include "solver/engine/stage/limit_search.h"
#include "solver/engine/stage/limits.h"
#include "solver/engine/stage/preload.h"
#include "solver/engine/stage/resticks.h"
#include "solver/engine/stage/step_accept.h"
#include "solver/engine/stage/step_build.h"
#include "solver/engine/stage/step_energy.h"
#include "solver/engine/step/step_forces.h"
#include "solver/engine/support.h"
#include "solver/engine/time/mass.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace keyblock {
namespace {

constexpr double shortestTimeStep = 1e-6;  // over the given time step: if a shorter one is needed, the stage fails
constexpr double eventStep = 1e-3;  // over the given time step: within this time, an event is not located more closely
constexpr double locatedWithin = 1e-4;  // fraction of the strength
constexpr int mostLocatingTries = 40;  // in the search for an event
constexpr double nearShare = 1e-3;  // of the smallest block's size: minimum range of the contact search
constexpr double pathOfSmallest = 1e-5;  // of the smallest block's size: a longer move may enter through another edge
constexpr int mostPathsOfAStep = 2;  // repetitions of a step for this reason
constexpr double arcShare = 1e-2;  // of the reference force: allowed change of a force because blocks move on arcs
constexpr int mostArcs = 2;  // repetitions of a step because the change is larger, before the step is shortened
constexpr double arcStep = 1e-3;  // over the given time step: in shorter steps, arcs and glue are not checked
constexpr double mostCellTurn = 0.2;  // cell rotation per step [rad]; much more makes generalized-alpha gain energy
constexpr int mostTurns = 10;  // repetitions of a step because cells rotate otherwise than assumed for the glue
constexpr double closeEnergy = 1e-3;  // of the energy that a step loses: allowed balance error of the first solution
constexpr double mostEnergy = 1e-2;  // the same for the final solution; otherwise the step is shortened
constexpr double energyCut = 0.5;
constexpr double energyStep = 1.0 / 64.0;  // over the given time step: minimum after reductions for the energy

/// Whether the contact forces are also right at the final positions of the blocks, which move on arcs, not on straight
/// lines.
bool arcsHold(const Model& model, const std::vector<BlockMotion>& from, const StepProblem& problem,
              const std::vector<Contact>& contacts, const Eigen::VectorXd& d) {
    const auto wayOf = [&](std::size_t i) -> Vector6 { return d.segment<6>(6 * static_cast<Eigen::Index>(i)); };
    double arc = 0.0;
    for (std::size_t i = 0; i < from.size(); ++i)
        arc = std::max(arc, model.blocks[i].size * wayOf(i)[2] * wayOf(i)[2]);
    if (arc < model.tolerance) return true;  // in most steps, nothing rotates this far
    std::vector<BlockMotion> blocks = from;
    for (std::size_t i = 0; i < blocks.size(); ++i)
        if (!model.blocks[i].fixed) moveBlock(model.blocks[i], blocks[i], wayOf(i));
    std::vector<double> strains;
    linkStrains(problem, d, strains);
    const double reference = referenceForce(problem, d, netForce(problem, d));
    for (std::size_t i = 0; i < strains.size(); ++i) {
        const Link& link = problem.links[i];
        if (!ofContact(link.kind)) continue;
        const Contact& c = contacts[link.owner];
        const double strain = link.kind == LinkKind::Normal ? gapOf(blocks, c) + link.shift : slipOf(blocks, c);
        const double off = respond(link.law, strain).force - respond(link.law, strains[i]).force;
        if (std::abs(off) > arcShare * reference) return false;
    }
    return true;
}

/// Whether the forces of point supports are also right at the final positions of the blocks, compared with the loads of
/// their block and the forces of its supports.
bool supportArcsHold(const Model& model, const State& from, const StepProblem& problem, const Eigen::VectorXd& d) {
    std::vector<double> reference = problem.ownForce, beyond(reference.size(), 0.0);
    for (const Link& link : problem.links) {
        if (link.kind != LinkKind::Support) continue;
        const std::size_t row = link.a;
        const Vector6 way = d.segment<6>(6 * static_cast<Eigen::Index>(link.a));
        if (model.blocks[row].size * way[2] * way[2] < model.tolerance) continue;
        const double strain = link.strain + link.shift + link.ga.dot(way);
        BlockMotion end = from.blocks[row];
        moveBlock(model.blocks[row], end, way);
        reference[row] += std::abs(respond(problem, link, strain).force);
        beyond[row] += link.law.stiffness * std::abs(supportStrain(model, end, link) - strain);
    }
    for (std::size_t i = 0; i < reference.size(); ++i)
        if (beyond[i] > arcShare * reference[i]) return false;
    return true;
}

/// The given time step, divided evenly if cells would rotate too far in it, so that steps are equal while cells spin
/// evenly.
double longestStep(const Model& model, const State& state, double given) {
    double spin = 0.0;
    for (std::size_t i = 0; i < model.blocks.size(); ++i)
        if (model.blocks[i].cell && !state.blocks[i].absent) spin = std::max(spin, std::abs(state.blocks[i].velocity[2]));
    return given / std::max(1.0, std::ceil(spin * given / mostCellTurn));
}

/// True if a cell rotates too far. Spin that arises within the step itself may reach twice the limit.
bool turnsTooFar(const Model& model, const Eigen::VectorXd& d) {
    for (std::size_t i = 0; i < model.blocks.size(); ++i)
        if (model.blocks[i].cell && std::abs(d[6 * static_cast<Eigen::Index>(i) + 2]) > 2.0 * mostCellTurn) return true;
    return false;
}

/// Acceleration that counts as none in one step [m/s2].
double negligibleAcceleration(const Model& model, const LoadPoint& at) {
    return balancedInMotion * model.numerics.tolerance * weightPerMass(model, at);
}

/// Per block: unbalanced force that counts as none in one step [N].
std::vector<double> negligibleForces(const Model& model, const LoadPoint& at) {
    const double acceleration = negligibleAcceleration(model, at);
    std::vector<double> forces;
    forces.reserve(model.blocks.size());
    for (const BlockModel& block : model.blocks) forces.push_back(acceleration * block.mass);
    return forces;
}

/// Largest speed of any point of a block, estimated from above, and of any bolt node [m/s].
double largestSpeed(const Model& model, const State& state) {
    double largest = 0.0;
    for (std::size_t i = 0; i < model.blocks.size(); ++i) {
        const Vector6& v = state.blocks[i].velocity;
        largest = std::max(largest, v.head<2>().norm() + v.tail<4>().cwiseAbs().sum() * model.blocks[i].size);
    }
    for (const BoltMotion& bolt : state.bolts)
        for (const BoltNode& node : bolt.nodes) largest = std::max(largest, node.velocity.head<2>().norm());
    return largest;
}

/// Ends a step in which nothing moves at rest if the momentum at its start was negligible, too. Otherwise the velocities
/// would change their signs in every further step.
/// \param negligible speed that counts as none [m/s].
void comeToRest(const Model& model, double negligible, State& state) {
    if (!state.acceleration.empty() || largestSpeed(model, state) > negligible) return;
    state.energy.damped += kineticEnergy(model, state);
    stopMotion(state);
}

/// Length of the next step to try in the search for a limit [s].
double nextTime(LimitSearch& search) {
    const double next = search.next(), low = search.high() - search.width();
    return next > low && next < search.high() ? next : low + 0.5 * search.width();
}

}  // namespace

DynamicStage::DynamicStage(Engine& engine, const Loads& loads, std::function<LoadPoint(double)> loadsAt,
                           DynamicSettings settings)
    : engine_(engine), loads_(loads), loadsAt_(std::move(loadsAt)), settings_(settings) {}

/// Gives driven blocks the initial velocity of their prescribed motion; the kinetic energy is external work.
void DynamicStage::drive(State& state) const {
    const LoadPoint first = loadsAt_(0.0), next = loadsAt_(settings_.timeStep);
    const double before = kineticEnergy(engine_.model, state);
    for (std::size_t i = 0; i < loads_.motions.size(); ++i) {
        const PrescribedMotion& motion = loads_.motions[i];
        Vector6& velocity = state.blocks[motion.block].velocity;
        velocity[0] = (next.motions[i] - first.motions[i]) / settings_.timeStep;
        if (motion.holdsRotation) velocity[2] = 0.0;
    }
    state.energy.external += kineticEnergy(engine_.model, state) - before;
}

StepEnding DynamicStage::begin(State& state, bool inMotion) {
    state.acceleration.clear();
    if (!inMotion && !takePreload(engine_, state, loads_, loadsAt_(0.0), settings_.timeStep))
        return {Ending::Stopped, "", {}};
    engine_.solver.forgetTrend();
    drive(state);
    if (!carriesAccelerations(settings_.scheme)) return {};
    const Eigen::VectorXd first = accelerationsAt(state, 0.0, settings_.damping);
    state.acceleration.assign(first.data(), first.data() + first.size());
    return {};
}

/// Accelerations due to all forces except contacts, with the bodies at their present positions.
Eigen::VectorXd DynamicStage::accelerationsAt(const State& state, double time, const Damping& damping) const {
    const Model& model = engine_.model;
    const StepProblem problem =
        buildStep(model, state, loads_, loadsAt_(time), {Inertia::None, 1.0, false, 1.0, damping});
    const Eigen::VectorXd still = Eigen::VectorXd::Zero(problem.unknowns());
    return byMass(model, problem, netForce(problem, still) - contactForce(problem, still));
}

void DynamicStage::setAccelerations(State& state, double time, const std::vector<char>& chosen) const {
    if (!carriesAccelerations(settings_.scheme)) return;
    const Eigen::VectorXd now = accelerationsAt(state, time, settings_.damping);
    const int blocks = static_cast<int>(engine_.model.blocks.size());
    for (int body = 0; body < static_cast<int>(chosen.size()); ++body) {
        const int first = body < blocks ? 6 * body : 6 * blocks + 3 * (body - blocks);
        for (int k = first; chosen[body] && k < first + (body < blocks ? 6 : 3); ++k) state.acceleration[k] = now[k];
    }
}

/// The accelerations without damping, to find what a failed part contributed to them. Empty if they are not needed.
Eigen::VectorXd DynamicStage::heldAccelerations(const State& state) const {
    if (!carriesAccelerations(settings_.scheme) || state.bolts.empty()) return {};
    return accelerationsAt(state, 0.0, {});
}

/// Removes the contribution of failed parts from the accelerations; otherwise it would throw light bolt nodes away.
void DynamicStage::forget(const Eigen::VectorXd& held, State& state) const {
    if (held.size() == 0) return;
    const Eigen::VectorXd now = heldAccelerations(state);
    for (Eigen::Index i = 0; i < held.size(); ++i)
        if (now[i] != held[i]) state.acceleration[i] += now[i] - held[i];
}

/// Loads at the time at which the scheme evaluates them, prescribed motions at the end of the step.
LoadPoint DynamicStage::loadsOver(double time, double dt, double share) const {
    LoadPoint at = loadsAt_(time + share * dt);
    if (share < 1.0) {
        const LoadPoint end = loadsAt_(time + dt);
        at.motions = end.motions;
        at.openings = end.openings;
    }
    return at;
}

double DynamicStage::predictedMove(const State& state, double dt, const DynamicPace& pace) const {
    const Model& model = engine_.model;
    double speed = 0.0;
    for (std::size_t i = 0; i < model.blocks.size(); ++i)
        speed = std::max(speed, state.blocks[i].velocity.head<2>().norm() +
                                    std::abs(state.blocks[i].velocity[2]) * 2.0 * model.blocks[i].size);
    return std::max(pace.lastMove, speed * dt + 0.5 * model.gravity.norm() * dt * dt);
}

double DynamicStage::searchRange(const State& state, double dt, const DynamicPace& pace) const {
    const double least = nearShare * engine_.model.smallest;
    return 4.0 * std::max(least, predictedMove(state, dt, pace)) + widestOpening(state);
}

DynamicStage::Attempt DynamicStage::attempt(const State& state, double time, double dt, DynamicPace& pace,
                                            FoundStep& trial) {
    const Model& model = engine_.model;
    StepOptions options{settings_.scheme, dt, false, settings_.rhoInf, settings_.damping};
    const LoadPoint at = loadsOver(time, dt, factorsOf(options).loadTime);
    const double least = nearShare * model.smallest;
    double margin = std::max(least, 2.0 * predictedMove(state, dt, pace));
    Eigen::VectorXd guess = Eigen::VectorXd::Zero(6 * static_cast<Eigen::Index>(model.blocks.size()) + 3 * model.nodes);
    for (std::size_t i = 0; i < model.blocks.size(); ++i)
        guess.segment<6>(6 * static_cast<Eigen::Index>(i)) = dt * state.blocks[i].velocity;
    Eigen::VectorXd path = guess, start = guess;  // a repeated step starts from its last solution
    if (trial.taken.d.size() > 0) start = (dt / trial.taken.options.dt) * trial.taken.d;  // the last try, scaled
    bool again = false;
    Eigen::VectorXd cellPath;
    for (int paths = 0, arcs = 0, turns = 0;; again = true) {
        trial.state = state;
        FoundCorners corners;
        trial.state.contacts = findContacts(model, state.blocks, state.contacts,
                                            {2.0 * margin + widestOpening(state), false, false, &path,
                                             &trial.state.energy.released, &corners, paths == 0, &engine_.neighbours});
        meetDilated(state, trial.state.contacts);
        StepProblem problem = buildStep(model, trial.state, loads_, at, options);
        problem.startForce = negligibleForces(model, at);
        Eigen::VectorXd d = start;
        const SolveReport report = solveStep(
            engine_, problem, trial.state, d,
            {.tolerance = model.numerics.tolerance, .fromGuess = again, .sweepsFirst = &pace.sweepsFirst});
        worst_ = report.worst;
        if (report.stopped) return Attempt::Stopped;
        if (!report.converged) return Attempt::TooLong;
        const double move = largestMove(model, problem, d);
        if (move > margin) {  // something beyond the search range may have been reached
            margin = 2.0 * move;
            if (margin > 0.25 * model.smallest && !state.contacts.empty()) return Attempt::TooLong;
            start = d;
            continue;
        }
        if (paths < mostPathsOfAStep && move > pathOfSmallest * model.smallest &&
            !entrancesHold(model, state.blocks, trial.state.contacts, corners, d)) {
            path = start = d;
            ++paths;
            continue;
        }
        if (dt > arcStep * settings_.timeStep && !(arcsHold(model, state.blocks, problem, trial.state.contacts, d) &&
                                                   supportArcsHold(model, state, problem, d))) {
            if (arcs == mostArcs) return Attempt::TooLong;
            guess = start = d;
            options.path = &guess;
            ++arcs;
            continue;
        }
        if (turnsTooFar(model, d)) return Attempt::TooLong;
        if (dt > arcStep * settings_.timeStep && !glueHolds(model, state.blocks, problem, d)) {
            if (turns == mostTurns) return Attempt::TooLong;
            cellPath = start = d;
            options.cellPath = &cellPath;
            ++turns;
            continue;
        }
        pace.lastMove = move;
        double total = 0.0;
        const Eigen::VectorXd external = externalForce(model, trial.state, loads_, at, moveOf(options), total);
        accountStep(model, trial.state, problem, external, d, options);
        moveOn(model, trial.state, problem, d, options);
        if (d.isZero(0.0)) comeToRest(model, 0.5 * dt * negligibleAcceleration(model, at), trial.state);
        acceptStep(model, trial.state, problem, d);
        trial.residual = report.residual;
        const bool knowsPath = std::exchange(options.path, nullptr) != nullptr;
        options.cellPath = nullptr;
        trial.taken = {{}, std::move(problem), std::move(d), at, options, knowsPath ? guess : Eigen::VectorXd{}};
        if (energyCut * dt < energyStep * settings_.timeStep) return Attempt::Settled;
        const StepEnergy energy = energyOfStep(model, state, trial.state);
        if (!knowsPath && energy.leavesMoreThan(closeEnergy)) {
            guess = start = cellPath = trial.taken.d;
            options.path = &guess;
            options.cellPath = &cellPath;
            continue;
        }
        return energy.leavesMoreThan(mostEnergy) ? Attempt::Unbalanced : Attempt::Settled;
    }
}

StepEnding DynamicStage::step(State& state, double& time, double end, DynamicPace& pace, StepObserver& observer) {
    FoundStep found;
    StepEnding ending = find(state, time, end, pace, found);
    if (ending.ending == Ending::Done) take(std::move(found), state, time, end, pace, observer);
    return ending;
}

StepEnding DynamicStage::find(const State& state, double time, double end, DynamicPace& pace, FoundStep& found) {
    const Model& model = engine_.model;
    const double rest = end - time;
    if (pace.dt == 0.0) pace.dt = settings_.timeStep;
    double dt = std::min(pace.dt, longestStep(model, state, settings_.timeStep));
    if (dt >= rest * (1.0 - 1e-9)) dt = rest;
    std::optional<LimitSearch> search;  // once a limit is exceeded
    for (int tries = 0;; ++tries) {
        const Attempt attempted = attempt(state, time, dt, pace, found);
        if (attempted == Attempt::Stopped) return {Ending::Stopped, "", {}};
        if (attempted == Attempt::TooLong) {
            ++engine_.health.stepCuts;
            search.reset();
            dt = cutStep(pace, dt);
            if (dt >= shortestTimeStep * settings_.timeStep) continue;
            StepEnding failed{Ending::Failed, "no time step converges near " + nameOfBody(model, worst_), {}};
            if (blockOfBody(model, worst_) >= 0) failed.blocks.push_back(worst_);
            return failed;
        }
        if (attempted == Attempt::Unbalanced) {
            ++engine_.health.energyCuts;
            search.reset();
            dt *= energyCut;
            pace.dt = dt;
            continue;
        }
        std::vector<Limit> limits = heldLimits(model, found.state);
        const auto worst = worstLimit(limits, 0.0);
        const double ratio = worst ? worst->ratio : 0.0;
        const bool over = ratio > 1.0 + locatedWithin;
        const bool located = ratio >= 1.0 - locatedWithin || !search;
        if (!over && located) break;
        if (!search) search.emplace(0.0, heldLimits(model, state), dt, std::move(limits));
        else if (dt == search->high()) break;
        else search->take(dt, std::move(limits), over);
        const bool close = search->width() <= eventStep * settings_.timeStep || tries > mostLocatingTries;
        if (close && over) break;
        dt = close ? search->high() : nextTime(*search);  // a step that ends before the limit would not release it
    }
    found.dt = dt;
    found.atLimit = search.has_value();
    return {};
}

void DynamicStage::take(FoundStep found, State& state, double& time, double end, DynamicPace& pace,
                        StepObserver& observer) {
    const Model& model = engine_.model;
    reportResticks(model, ifSliding(state), found.state, time, -1, observer);
    engine_.taken = std::move(found.taken);
    engine_.taken.before = std::exchange(state, std::move(found.state));
    time = later(time, found.dt, end, pace.roundedUp);
    lengthenStep(pace, found.dt, settings_.timeStep);
    engine_.taken.step = ++state.step;
    countAccepted(engine_, state, found.residual);
    const Eigen::VectorXd held = heldAccelerations(state);
    double least = found.atLimit ? 1.0 - locatedWithin : 1.0 + reachedShare;
    while (const auto limit = worstLimit(heldLimits(model, state), least)) {
        releaseAndReport(model, state, *limit, time, -1, observer);
        observer.afterEvent(state, time);
        least = 1.0 + reachedShare;
    }
    followBolts(model, state);
    forget(held, state);
}

}  // namespace keyblock
