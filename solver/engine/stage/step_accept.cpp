// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/stage/step_accept.h"

#include "solver/engine/bolt/motion.h"
#include "solver/engine/stage/carriers.h"
#include "solver/engine/step/phase.h"
#include "solver/engine/step/step_forces.h"

namespace keyblock {
namespace {

SolvedLink solvedLink(const StepProblem& problem, std::size_t row, double strain) {
    const Link& link = problem.links[row];
    SolvedLink solved{link, strain};
    if (link.law.kind == LawKind::Curve) {
        const BackboneResponse r = respond(*link.law.curve, link.law.state, strain);
        solved.force = r.force;
        solved.curve = r.state;
        solved.plasticWork = r.plasticWork;
    } else {
        solved.force = respond(link.law, strain).force;
    }
    solved.slipForce = problem.slipForce.empty() ? solved.force : problem.slipForce[row];
    return solved;
}

std::vector<SolvedLink> solvedLinks(const StepProblem& problem, const Eigen::VectorXd& d) {
    std::vector<double> strains;
    linkStrains(problem, d, strains);
    std::vector<SolvedLink> links;
    links.reserve(strains.size());
    for (std::size_t i = 0; i < strains.size(); ++i) links.push_back(solvedLink(problem, i, strains[i]));
    return links;
}

}  // namespace

void moveBodies(const Model& model, State& state, const Eigen::VectorXd& d) {
    moveBolts(model, state, d);
    for (std::size_t i = 0; i < model.blocks.size(); ++i)
        if (!model.blocks[i].fixed && !model.blocks[i].asleep)
            moveBlock(model.blocks[i], state.blocks[i], d.segment<6>(6 * static_cast<Eigen::Index>(i)));
}

void acceptStep(const Model& model, State& state, const StepProblem& problem, const Eigen::VectorXd& d) {
    const PhaseScope phase(Phase::Accept);
    const std::vector<SolvedLink> links = solvedLinks(problem, d);
    for (const SolvedLink& solved : links)
        if (const Carrier* carrier = carrierOf(solved.link.kind)) carrier->accept(model, state, solved);
    if (!problem.openings.empty()) state.openings = problem.openings;
    moveBodies(model, state, d);
    for (const SolvedLink& solved : links)
        if (const Carrier* carrier = carrierOf(solved.link.kind)) carrier->relock(model, state, solved);
    for (const Carrier* carrier : carriers)
        if (carrier->finish) carrier->finish(state);
}

}  // namespace keyblock
