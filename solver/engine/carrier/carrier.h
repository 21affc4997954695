// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What everything that carries force can do. Contacts, glue, point supports,
// bolts, damping and dashpots each fill in one `Carrier`; steps, limits and energies
// loop over the list of them (stage/carriers.h) and know none by name. A new
// law or a lining is a file with such a table, and a row of that list.
#pragma once

#include "solver/engine/carrier/limit.h"
#include "solver/engine/model/loads.h"
#include "solver/engine/model/state.h"
#include "solver/engine/step/step_problem.h"
#include "solver/engine/time/time_scheme.h"

#include <vector>

namespace keyblock {

/// What the links of a step are made from. The state's contacts were found for the step.
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
    double force = 0.0;  // there, before the law's share
    double slipForce = 0.0;  // mean force while it slid, or the force at the end; before the law's share
    BackboneState curve{};  // new state of a law with a curve
    double plasticWork = 0.0;  // of such a law over the step, before its share
};

/// Elastic energy by kind [J].
struct StoredEnergy {
    double strain = 0.0;  // of blocks, their glue and their supports
    double contact = 0.0;
    double bolt = 0.0;
};

/// A null function: the carrier has nothing of that kind.
struct Carrier {
    const char* name = "";

    /// Adds its links to a step whose bodies and loads are complete.
    void (*addLinks)(const StepInput& input, StepProblem& problem) = nullptr;

    /// True for links that it accepts.
    bool (*ownsLink)(LinkKind kind) = nullptr;

    /// Takes force and history of one of its links into the state, before the bodies move.
    void (*accept)(const Model& model, State& state, const SolvedLink& solved) = nullptr;

    /// After the bodies have moved: moves the zero point of a law that slid or flowed, so that it carries the accepted
    /// force where the bodies are now, and accounts for the work.
    void (*relock)(const Model& model, State& state, const SolvedLink& solved) = nullptr;

    /// Last of an accepted step, once for all links.
    void (*finish)(State& state) = nullptr;

    /// Lists its limits that still hold, in the order in which ties are broken.
    void (*addLimits)(const Model& model, const State& state, std::vector<Limit>& limits) = nullptr;

    /// True for limits that it releases.
    bool (*ownsLimit)(LimitKind kind) = nullptr;

    /// True where releasing it changes forces, so that equilibrium must be found again.
    bool (*changesForces)(const Model& model, const Limit& limit) = nullptr;

    /// Releases one of its limits. \return the events, with forces and slip just before.
    std::vector<Event> (*release)(const Model& model, State& state, const Limit& limit) = nullptr;

    /// Adds forces that blocks about to be excavated exert on those that stay. \param excavated a row per block
    void (*addWallForces)(const Model& model, const State& state, const std::vector<char>& excavated,
                          std::vector<WallForce>& walls) = nullptr;

    /// Adds its elastic energy where the bodies are [J].
    void (*addStoredEnergy)(const Model& model, const State& state, StoredEnergy& energy) = nullptr;
};

/// True where a capped law is at its limit, but for round-off: friction under less has not slid.
bool reachesLimit(const Law& law, double force);

/// A step without bodies' matrices, to which links can be added to look at them.
StepProblem stepForLinks(const Model& model);

/// Elastic energy of the links where they are, added to `sum` one by one [J].
double addLinkEnergy(const StepProblem& problem, double sum);

}  // namespace keyblock
