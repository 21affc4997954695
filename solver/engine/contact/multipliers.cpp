// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/contact/multipliers.h"

#include "solver/engine/contact/springs.h"
#include "solver/engine/step/step_forces.h"

#include <algorithm>
#include <cmath>

namespace keyblock {
namespace {

constexpr double allowedShare = 1e-9;  // of the smaller block's size: accepted penetration and elastic slip

/// Calls `visit(link, contact, strain, force)` for the links of contacts that have multipliers.
template <typename Problem, typename States, typename Visit>
void forEachLink(Problem& problem, States& state, const Eigen::VectorXd& d, const Visit& visit) {
    std::vector<double> strains;
    linkStrains(problem, d, strains);
    for (std::size_t i = 0; i < strains.size(); ++i) {
        auto& link = problem.links[i];
        if (!link.law.rigid || link.law.stiffness <= 0.0) continue;
        auto& contact = state.contacts[link.owner];
        visit(link, contact, strains[i], respond(link.law, strains[i]).force);
    }
}

double zeroPoint(const Link& link, const Contact& c) {
    return link.kind == LinkKind::Normal ? c.gapOffset : c.slipOffset;
}

void setMultiplier(const Link& link, Contact& c, double force) {
    (link.kind == LinkKind::Normal ? c.normalMultiplier : c.shearMultiplier) =
        link.kind == LinkKind::Normal ? -force : force;
}

}  // namespace

bool usesMultipliers(const Model& model) { return model.numerics.contact == ContactMethod::AugmentedLagrangian; }

double multiplierError(const Model& model, const State& state, const StepProblem& problem, const Eigen::VectorXd& d) {
    double worst = 0.0;
    forEachLink(problem, state, d, [&](const Link& link, const Contact& c, double strain, double force) {
        const bool slides = link.law.kind == LawKind::Capped && std::abs(force) >= link.law.limit;
        if (force == 0.0 || slides) return;
        const double left = std::abs(strain - zeroPoint(link, c));
        worst = std::max(worst, left / std::min(model.blocks[c.blockA].size, model.blocks[c.blockB].size));
    });
    return worst / allowedShare;
}

void takeMultipliers(State& state, StepProblem& problem, const Eigen::VectorXd& d, double stiffer) {
    forEachLink(problem, state, d, [&](Link& link, Contact& c, double, double force) {
        setMultiplier(link, c, force);
        link.law.stiffness *= stiffer;
        link.law.offset = zeroPoint(link, c) - force / link.law.stiffness;
    });
}

void keepMultipliers(const Model& model, State& state, const StepProblem& problem, const Eigen::VectorXd& d) {
    forEachLink(problem, state, d, [&](const Link& link, Contact& c, double strain, double force) {
        const ContactSprings k = contactSprings(model, c);
        const bool open = link.law.kind == LawKind::Gap && force == 0.0;
        const double left = (link.kind == LinkKind::Normal ? k.normal : k.shear) * (strain - zeroPoint(link, c));
        setMultiplier(link, c, open ? 0.0 : force - left);
    });
}

}  // namespace keyblock
