// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Rayleigh damping of a step: a force a·M·v on every body, and b times the
// elastic stiffness against the rate of strain of blocks, of the glue between
// their cells and of bolts' shanks.
// Springs of contacts, supports and anchors have none: what they lose is
// friction, and a viscous part would pass the limits that they obey.
#include "solver/engine/stage/step_build.h"

namespace keyblock {
namespace {

/// Rate of a link's strain that velocities (or accelerations) of all unknowns make.
double strainRate(const StepProblem& problem, const Link& link, const Eigen::VectorXd& velocity) {
    const int wa = problem.width(link.a), wb = problem.width(link.b);
    return link.ga.head(wa).dot(velocity.segment(problem.first(link.a), wa)) +
           link.gb.head(wb).dot(velocity.segment(problem.first(link.b), wb));
}

}  // namespace

void addDamping(const Model& model, const State& state, const StepOptions& options, StepProblem& problem) {
    const SchemeFactors factors = factorsOf(options);
    const Damping& damping = options.damping;
    const Eigen::VectorXd motion =
        factors.rate.v * velocitiesOf(model, state) + factors.rate.a * accelerationsOf(model, state);
    problem.load -= damping.mass * timesMass(model, motion);
    for (std::size_t i = 0; i < model.blocks.size(); ++i) {
        const BlockModel& block = model.blocks[i];
        const auto at = 6 * static_cast<Eigen::Index>(i) + 3;
        const Eigen::Matrix3d strains = damping.stiffness * block.area * model.thickness * block.elasticity;
        problem.blockStiffness[i] += factors.rate.d * damping.mass * block.massMatrix;
        problem.blockStiffness[i].bottomRightCorner<3, 3>() += factors.rate.d * strains;
        problem.load.segment<3>(at) -= strains * motion.segment<3>(at);
    }
    std::size_t node = 0;
    for (const BoltModel& bolt : model.bolts)
        for (std::size_t n = 0; n < bolt.s.size(); ++n)
            problem.nodeStiffness[node++] += factors.rate.d * damping.mass * nodeMass(bolt, n);
    const std::size_t links = damping.stiffness > 0.0 ? problem.links.size() : 0;
    for (std::size_t i = 0; i < links; ++i) {
        const LinkKind kind = problem.links[i].kind;
        const bool ofShank = kind == LinkKind::Axial || kind == LinkKind::Bend || kind == LinkKind::Shear;
        if (!ofShank && kind != LinkKind::Glue) continue;
        Link drag = problem.links[i];
        const double force = damping.stiffness * drag.law.stiffness * strainRate(problem, drag, motion);
        const double stiffness = damping.stiffness * drag.law.stiffness * factors.rate.d;
        drag.kind = LinkKind::Drag;
        const double share = drag.law.share;
        drag.law = {};
        drag.law.share = share;
        drag.law.kind = stiffness > 0.0 ? LawKind::Viscous : LawKind::Constant;
        drag.law.stiffness = stiffness;
        drag.law.limit = force;
        if (stiffness > 0.0) drag.law.offset = drag.strain - force / stiffness;
        problem.links.push_back(drag);
    }
}

double dampedWork(const Model& model, const State& state, const StepOptions& options, const Eigen::VectorXd& d) {
    const SchemeFactors factors = factorsOf(options);
    const Eigen::VectorXd rate = factors.rate.d * d + factors.rate.v * velocitiesOf(model, state) +
                                 factors.rate.a * accelerationsOf(model, state);
    double work = options.damping.mass * d.dot(timesMass(model, rate));
    for (std::size_t i = 0; i < model.blocks.size(); ++i) {
        const auto at = 6 * static_cast<Eigen::Index>(i) + 3;
        const double volume = model.blocks[i].area * model.thickness;
        work += options.damping.stiffness * volume *
                d.segment<3>(at).dot(model.blocks[i].elasticity * rate.segment<3>(at));
    }
    return work;
}

}  // namespace keyblock
