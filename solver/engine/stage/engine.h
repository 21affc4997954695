// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Data needed for solving steps in addition to the state: the solver with its matrix
// pattern, the solver diagnostics, and the callbacks for stopping and progress.
#pragma once

#include "solver/engine/carrier/limit.h"
#include "solver/engine/contact/neighbour_list.h"
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
    NeighbourList neighbours;  // of the contact search
    Health health;  // solver diagnostics of the run
    StepHealth newest;  // solver diagnostics of the latest step
    TakenStep taken;  // latest accepted dynamic step, for output only
    long passedStep = -1;  // number of the latest dynamic step that was passed because nothing could move
    std::function<bool()> stopAsked;  // called in every iteration; true stops the search
    std::function<void()> passed;  // called after every solved step to report progress

    explicit Engine(const Model& m) : model(m) {}
};

/// How a search for equilibrium or a dynamic step ended.
enum class Ending { Done, NoEquilibrium, Undecided, Stopped, Failed };

struct StepEnding {
    Ending ending = Ending::Done;
    std::string message;  // the failure and its location
    std::vector<int> blocks;  // blocks that move or are not in equilibrium
    std::vector<int> followers{};  // blocks set in motion by those
    long cause = -1;  // event after which no equilibrium was found; −1: the load increment
    bool final = false;  // a longer search or another release would not change it
};

/// Receives the events within an increment or time step, in order.
class StepObserver {
public:
    virtual ~StepObserver() = default;
    /// Called with the state just before an event.
    virtual void beforeEvent(const State& state, double time) = 0;
    /// Called with the event and the state just before it.
    /// \return the number of the event in the run, from 0.
    virtual long event(Event event, const State& state, double time) = 0;
    /// Called with the state just after an event. In a static stage, equilibrium has normally been restored.
    virtual void afterEvent(const State& state, double time) = 0;
};

/// Releases a limit and reports the resulting events, each with the state just before the event.
/// \param cause the number of the event that caused the limit to be exceeded; −1: the load.
/// \return the number of the last event.
long releaseAndReport(const Model& model, State& state, const Limit& limit, double time, long cause,
                      StepObserver& observer);

/// Options for solving a step, in addition to the settings of the scene.
struct StepNeeds {
    double tolerance = 1e-4;  // unbalanced force over the acting forces
    int maxPasses = 0;  // maximum number of iterations; 0: that of the scene
    bool convex = false;  // use Newton's method even if the scene selects open–close iteration
    bool fromGuess = false;  // as in `SolveSettings`
    SweepsFirst* sweepsFirst = nullptr;  // as in `SolveSettings`
};

/// Solves one step and includes it in the solver diagnostics. The friction limits of the solution are stored in the
/// contacts of `state`.
SolveReport solveStep(Engine& engine, StepProblem& problem, State& state, Eigen::VectorXd& d, const StepNeeds& needs);

/// Displacements [m] due to the unknowns in `d` that are not prescribed: an upper bound for the corners of a block
/// (`blockMove`), and the largest displacement of any bolt node (`nodeMove`).
double blockMove(const Model& model, const StepProblem& problem, const Eigen::VectorXd& d, std::size_t block);
double nodeMove(const StepProblem& problem, const Eigen::VectorXd& d);

/// Largest value of `blockMove` and `nodeMove` over all blocks and nodes [m].
double largestMove(const Model& model, const StepProblem& problem, const Eigen::VectorXd& d);

/// Index of the block that a body of a step represents, −1 for a bolt node; and the name of the body for messages.
/// \param body the index of the body: blocks first, then bolt nodes.
int blockOfBody(const Model& model, int body);
std::string nameOfBody(const Model& model, int body);

/// Updates the solver diagnostics with the largest penetration and the residual of an accepted state.
void countAccepted(Engine& engine, const State& state, double residual);

}  // namespace keyblock
