// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Common interface of all force carriers. Contacts, glue, point supports, bolts, damping
// and dashpots each provide one `Carrier`. The code for steps, limits and energies loops
// over their list (stage/carriers.h) without knowing them individually. A new kind of
// carrier, such as a lining, is one file with a `Carrier` and one row of that list.
#pragma once

#include "solver/engine/carrier/limit.h"
#include "solver/engine/model/loads.h"
#include "solver/engine/model/state.h"
#include "solver/engine/step/step_problem.h"
#include "solver/engine/time/time_scheme.h"

#include <vector>

namespace keyblock {

/// Input from which the links of a step are created. The contacts in the state have been found for this step.
struct StepInput {
    const Model& model;
    const State& state;
    const Loads& loads;
    const StepOptions& options;
};

/// A link of a solved step, with the response of its law.
struct SolvedLink {
    const Link& link;
    double strain = 0.0;  // at the end of the step
    double force = 0.0;  // at the end of the step, not multiplied by `Law::share`
    double slipForce = 0.0;  // mean force while sliding, or the force at the end; not multiplied by `Law::share`
    BackboneState curve{};  // new state of a law with a curve
    double plasticWork = 0.0;  // plastic work of a law with a curve over the step, not multiplied by `Law::share`
};

/// Elastic energy by kind [J].
struct StoredEnergy {
    double strain = 0.0;  // of blocks, glue and point supports
    double contact = 0.0;
    double bolt = 0.0;
};

/// A force carrier: its functions for links, limits and energy. A function that the carrier does not need is null.
struct Carrier {
    const char* name = "";

    /// Adds the carrier's links to a step whose bodies and loads are complete.
    void (*addLinks)(const StepInput& input, StepProblem& problem) = nullptr;

    /// True if the carrier accepts links of this kind.
    bool (*ownsLink)(LinkKind kind) = nullptr;

    /// Stores the force and history of one of the carrier's links in the state. Called before the bodies are moved.
    void (*accept)(const Model& model, State& state, const SolvedLink& solved) = nullptr;

    /// Called after the bodies have been moved. Shifts the zero point of a link that slipped or yielded so that it
    /// carries the accepted force at the new positions, and accounts for the work.
    void (*relock)(const Model& model, State& state, const SolvedLink& solved) = nullptr;

    /// Called once at the end of an accepted step, after `accept` and `relock` have been called for all links.
    void (*finish)(State& state) = nullptr;

    /// Adds the carrier's limits that have not failed yet. If several are exceeded by the same ratio, the one added
    /// first fails first.
    void (*addLimits)(const Model& model, const State& state, std::vector<Limit>& limits) = nullptr;

    /// True if the parts that fail at limits of this kind belong to this carrier.
    bool (*ownsLimit)(LimitKind kind) = nullptr;

    /// True if failure at the limit changes forces, so that equilibrium must be found again.
    bool (*changesForces)(const Model& model, const Limit& limit) = nullptr;

    /// Lets the part that has reached the limit fail. \return the resulting events, with forces and slip just before the
    /// failure.
    std::vector<Event> (*release)(const Model& model, State& state, const Limit& limit) = nullptr;

    /// Adds the forces that blocks about to be excavated exert on the remaining blocks and bolts.
    /// \param excavated indexed by block; nonzero if the block is to be excavated.
    void (*addWallForces)(const Model& model, const State& state, const std::vector<char>& excavated,
                          std::vector<WallForce>& walls) = nullptr;

    /// Adds the carrier's elastic energy at the current positions of the bodies [J].
    void (*addStoredEnergy)(const Model& model, const State& state, StoredEnergy& energy) = nullptr;
};

/// True if the force of a capped law has reached its limit, apart from round-off. A friction link below its limit has
/// not slipped.
bool reachesLimit(const Law& law, double force);

/// A step problem without body matrices, to which links can be added so that they can be evaluated.
StepProblem stepForLinks(const Model& model);

/// Adds the elastic energies of the links in their current state to `sum`, one after the other. \return the total [J].
double addLinkEnergy(const StepProblem& problem, double sum);

}  // namespace keyblock
