// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/damping.h"

#include "solver/engine/time/mass.h"

namespace keyblock {
namespace {

/// Strain rate of a link due to velocities (or accelerations) of all unknowns.
double strainRate(const StepProblem& problem, const Link& link, const Eigen::VectorXd& velocity) {
    const int wa = problem.width(link.a), wb = problem.width(link.b);
    return link.ga.head(wa).dot(velocity.segment(problem.first(link.a), wa)) +
           link.gb.head(wb).dot(velocity.segment(problem.first(link.b), wb));
}

bool isDamped(LinkKind kind) {
    return kind == LinkKind::Axial || kind == LinkKind::Bend || kind == LinkKind::Shear || kind == LinkKind::Glue;
}

/// A dashpot that acts on the strain rate of a link, with the damping factor times the link's stiffness.
Link dragOf(const StepProblem& problem, const Link& link, double damping, const SchemeFactors& factors,
            const Eigen::VectorXd& motion) {
    Link drag = link;
    const double force = damping * drag.law.stiffness * strainRate(problem, drag, motion);
    const double stiffness = damping * drag.law.stiffness * factors.rate.d;
    drag.kind = LinkKind::Drag;
    if (factors.rate.v != 0.0) drag.shift = 0.0;  // the rate at one instant, not the mean over the step
    const double share = drag.law.share;
    drag.law = {};
    drag.law.share = share;
    drag.law.kind = stiffness > 0.0 ? LawKind::Viscous : LawKind::Constant;
    drag.law.stiffness = stiffness;
    drag.law.limit = force;
    if (stiffness > 0.0) drag.law.offset = drag.strain - force / stiffness;
    return drag;
}

void dampBodies(const Model& model, const Damping& damping, const SchemeFactors& factors,
                const Eigen::VectorXd& motion, StepProblem& problem) {
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
}

void addDampingLinks(const StepInput& input, StepProblem& problem) {
    const Damping& damping = input.options.damping;
    if (damping == Damping{}) return;
    const Model& model = input.model;
    const State& state = input.state;
    const SchemeFactors factors = factorsOf(input.options);
    const Eigen::VectorXd motion =
        factors.rate.v * velocitiesOf(model, state) + factors.rate.a * accelerationsOf(model, state);
    dampBodies(model, damping, factors, motion, problem);
    const std::size_t links = damping.stiffness > 0.0 ? problem.links.size() : 0;
    for (std::size_t i = 0; i < links; ++i)
        if (isDamped(problem.links[i].kind))
            problem.links.push_back(dragOf(problem, problem.links[i], damping.stiffness, factors, motion));
}

}  // namespace

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

const Carrier dampingCarrier{.name = "damping", .addLinks = addDampingLinks};

}  // namespace keyblock
