// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the solution of steps carries along beside the state: the solver with
// its pattern, the counts of the numbers' health, and how to be stopped.
#pragma once

#include "solver/engine/carrier/limit.h"
#include "solver/engine/model/loads.h"
#include "solver/engine/model/state.h"
#include "solver/engine/step/step_problem.h"
#include "solver/engine/stage/taken_step.h"
#include "solver/engine/step/step_solver.h"
#include "solver/results/results.h"

#include <functional>
#include <string>
#include <vector>

namespace keyblock {

struct Engine {
    const Model& model;
    StepSolver solver;
    Health health;
    StepHealth newest;
    TakenStep taken;  // the last step in motion; nothing of a run depends on it
    std::function<bool()> stopAsked;  // asked in every pass
    std::function<void()> passed;  // called after every solved step, for progress

    explicit Engine(const Model& m) : model(m) {}
};

/// How a search for equilibrium or a dynamic step ended.
enum class Ending { Done, NoEquilibrium, Undecided, Stopped, Failed };

struct StepEnding {
    Ending ending = Ending::Done;
    std::string message;  // what failed, and where
    std::vector<int> blocks;  // that move or do not balance
    std::vector<int> followers{};  // that those set moving
    long cause = -1;  // the event after which nothing balanced; −1: the load
    bool final = false;  // undecided, and a longer search would be, too
};

/// Is notified of what happens inside an increment or step, in order.
class StepObserver {
public:
    virtual ~StepObserver() = default;
    /// State just before something fails.
    virtual void beforeEvent(const State& state, double time) = 0;
    /// \return the event's number in the run, from 0.
    virtual long event(Event event, const State& state, double time) = 0;
    /// State just after, at equilibrium again in a static stage.
    virtual void afterEvent(const State& state, double time) = 0;
};

/// Releases a limit and reports the events that this is, each with the state before it.
/// \param cause the event that set it over; −1: the load did. \return the number of the last event.
long releaseAndReport(const Model& model, State& state, const Limit& limit, double time, long cause,
                      StepObserver& observer);

/// How a step is to be solved, beside what the scene asks for.
struct StepNeeds {
    double tolerance = 1e-4;  // over the forces at play
    int maxPasses = 0;  // instead of the scene's, where above zero
    bool convex = false;  // whatever iteration the scene asks for
    bool again = false;  // as of `SolveSettings`
    int sweepsFrom = 0;  // as of `SolveSettings`
    bool* sweepsFirst = nullptr;  // as of `SolveSettings`
};

/// Solves one step and counts it. Friction limits used are kept in the state's contacts.
SolveReport solveStep(Engine& engine, StepProblem& problem, State& state, Eigen::VectorXd& d, const StepNeeds& needs);

/// √area of the smallest block [m].
double smallestSize(const Model& model);

/// Largest move of a corner of a block, or of a node, by what is not prescribed in `d` [m].
double blockMove(const Model& model, const StepProblem& problem, const Eigen::VectorXd& d, std::size_t block);
double nodeMove(const StepProblem& problem, const Eigen::VectorXd& d);

/// The largest of these [m].
double largestMove(const Model& model, const StepProblem& problem, const Eigen::VectorXd& d);

/// Block behind a body of a step, −1 for a node; and its name for a message.
int blockOfBody(const Model& model, int body);
std::string nameOfBody(const Model& model, int body);

/// Counts an accepted state: deepest penetration and residual.
void countAccepted(Engine& engine, const State& state, double residual);

}  // namespace keyblock
