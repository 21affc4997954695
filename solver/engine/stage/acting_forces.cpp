// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A link has no point of action, only the gradient of its strain with respect to the unknowns of a block. The gradient
// is T(x)ᵀ·n, from which both the direction n and the point x follow, except for the rotation within a step. The point
// of a support is known. So the forces of every carrier that adds links to a step are listed here, without code in the
// carrier.
#include "solver/engine/stage/acting_forces.h"

#include "solver/engine/stage/step_build.h"
#include "solver/engine/step/friction_limits.h"
#include "solver/engine/step/step_forces.h"
#include "solver/engine/time/mass.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace keyblock {
namespace {

constexpr double samePlace = 1e-9;  // of a block's size: within this distance, two positions are the same
constexpr double noDirection = 1e-12;  // a gradient with a smaller direction is that of a couple

ForceSource sourceOf(const Link& link) {
    switch (link.kind) {
        case LinkKind::Normal:
        case LinkKind::Friction: return ForceSource::Contact;
        case LinkKind::Glue: return ForceSource::Glue;
        case LinkKind::Support: return ForceSource::Support;
        case LinkKind::Drag: return link.b >= 0 ? ForceSource::Glue : ForceSource::Dashpot;
        default: return ForceSource::Bolt;
    }
}

bool ofPlateLink(LinkKind kind) { return kind == LinkKind::PlateNormal || kind == LinkKind::PlateShear; }

/// Global vector from two components along the axes of a block's unknowns.
Point globalOf(const BlockMotion& motion, double first, double second) {
    return first * motion.axis + second * turnLeft(motion.axis);
}

/// Arm from the centroid to the point of a gradient T(x)ᵀ·n [m]; n need not be a unit vector but must not be 0.
Point armOf(const BlockMotion& motion, const Vector6& gradient) {
    const double length = gradient.head<2>().norm();
    const Vector6 g = gradient / length;
    const Point global = globalOf(motion, g[0], g[1]), along(std::cos(motion.angle), std::sin(motion.angle));
    const Point n(global.dot(along), global.dot(turnLeft(along)));  // in the frame of the block, like its strains
    const Point place(n.x() * (g[3] - g[4]) + 2.0 * n.y() * g[5], n.y() * (g[4] - g[3]) + 2.0 * n.x() * g[5]);
    return materialPoint(motion, place) - motion.centroid;
}

/// A list of forces; the total force of one contact, bond, support, anchored point or plate at one point is one row.
class ForceList {
public:
    /// \param move of the blocks over the step; it defines the lever arms of the supports.
    ForceList(const Model& model, const State& state, const StepMove& move) : model_(model), state_(state), move_(move) {}

    /// \param force generalised force on the block; only its first three rows are used.
    void add(const SingleForce& part, const Vector6& force) {
        if (state_.blocks[at(part.force.block)].absent || force.head<3>().isZero(0.0)) return;
        SingleForce row = part;
        const BlockMotion& motion = state_.blocks[at(row.force.block)];
        row.force.force = globalOf(motion, force[0], force[1]);
        row.force.moment = force[2];
        forces_.push_back(row);
    }

    /// Adds the forces at both ends of a link under `force`, which includes the link's share.
    void addLink(const StepProblem& problem, const Link& link, double force) {
        addEnd(problem, link, link.a, link.b, link.ga, force);
        if (link.b >= 0) addEnd(problem, link, link.b, link.a, link.gb, force);
    }

    std::vector<SingleForce> take() { return std::move(forces_); }

private:
    static std::size_t at(int block) { return block; }

    void addEnd(const StepProblem& problem, const Link& link, int body, int other, const Vector6& gradient, double force) {
        if (body >= problem.blocks || force == 0.0) return;
        SingleForce part;
        part.force.block = body;
        part.force.source = sourceOf(link);
        if (part.force.source == ForceSource::Bolt) part.force.other = link.owner;
        else if (other >= 0) part.force.other = other;
        if (ofContact(link.kind) || part.force.source == ForceSource::Glue) part.part = link.owner;
        if (part.force.source == ForceSource::Bolt && !ofPlateLink(link.kind)) part.part = other - problem.blocks;
        SingleForce* row = part.part >= 0 ? rowFor(part) : nullptr;  // all its links act at one point
        if (!row && gradient.head<2>().norm() >= noDirection)
            part.force.position = link.kind == LinkKind::Support ? armOfSupport(link)
                                                                 : armOf(state_.blocks[at(body)], gradient);
        if (part.part < 0) row = rowFor(part);
        if (row) join(*row, -force * gradient);
        else add(part, -force * gradient);
    }

    Point armOfSupport(const Link& link) const {
        const BlockMotion motion = onTheWay(model_, state_, link.a, move_);
        return materialPoint(motion, model_.supports[at(link.owner)].place) - motion.centroid;
    }

    /// The row of the same part, if it is among the last three; since then, each end has added one or two rows.
    SingleForce* rowFor(const SingleForce& part) {
        const std::size_t looked = std::min<std::size_t>(forces_.size(), 3);
        for (std::size_t i = forces_.size(); i > forces_.size() - looked; --i)
            if (isSame(forces_[i - 1], part)) return &forces_[i - 1];
        return nullptr;
    }

    bool isSame(const SingleForce& row, const SingleForce& part) const {
        const BlockForce &a = row.force, &b = part.force;
        if (a.block != b.block || a.source != b.source || a.other != b.other || row.part != part.part) return false;
        if (part.part >= 0) return true;
        return (a.position - b.position).norm() <= samePlace * model_.blocks[at(b.block)].size;
    }

    void join(SingleForce& row, const Vector6& force) const {
        row.force.force += globalOf(state_.blocks[at(row.force.block)], force[0], force[1]);
        row.force.moment += force[2];
    }

    const Model& model_;
    const State& state_;
    StepMove move_;
    std::vector<SingleForce> forces_;
};

/// A step and the data from which its forces follow.
struct StepView {
    const Model& model;
    const State& state;  // at the start of the step
    const Loads& loads;
    const LoadPoint& at;
    const StepOptions& options;
    const StepProblem& problem;
    const Eigen::VectorXd& d;
};

SingleForce onBlock(std::size_t block, ForceSource source) {
    SingleForce force;
    force.force.block = static_cast<int>(block);
    force.force.source = source;
    return force;
}

/// \param forces on every unknown.
void addBodyForces(const StepView& view, ForceSource source, const Eigen::VectorXd& forces, ForceList& list) {
    for (std::size_t i = 0; i < view.model.blocks.size(); ++i)
        list.add(onBlock(i, source), forces.segment<6>(6 * static_cast<Eigen::Index>(i)));
}

/// Generalised force on a block's translations and rotation.
Vector6 generalised(const BlockMotion& motion, const Point& force, double moment) {
    Vector6 rows = Vector6::Zero();
    rows.head<3>() << force.dot(motion.axis), force.dot(turnLeft(motion.axis)), moment;
    return rows;
}

void addLoads(const StepView& view, ForceList& list) {
    const Point perMass = accelerationOf(view.model, view.at);
    for (std::size_t i = 0; i < view.model.blocks.size(); ++i)
        list.add(onBlock(i, ForceSource::Weight),
                 generalised(view.state.blocks[i], view.model.blocks[i].mass * perMass, 0.0));
    for (const SingleLoad& load : singleLoads(view.model, view.state, view.loads, view.at, moveOf(view.options))) {
        if (load.block < 0) continue;
        SingleForce force = onBlock(static_cast<std::size_t>(load.block), load.source);
        force.force.position = load.arm;
        list.add(force, load.onUnknowns);
    }
}

void addLinks(const StepView& view, ForceList& list) {
    std::vector<double> strains;
    linkStrains(view.problem, view.d, strains);
    for (std::size_t i = 0; i < strains.size(); ++i) {
        const Link& link = view.problem.links[i];
        const double share = ofContact(link.kind) ? link.law.share / view.problem.contactShare : link.law.share;
        list.addLink(view.problem, link, share * respond(view.problem, link, strains[i]).force);
    }
}

/// Reactions at prescribed unknowns: the negative of the net force there.
void addReactions(const StepView& view, const Eigen::VectorXd& net, ForceList& list) {
    Eigen::VectorXd reaction = Eigen::VectorXd::Zero(net.size());
    for (Eigen::Index i = 0; i < net.size(); ++i)
        if (view.problem.known[i]) reaction[i] = -net[i];
    addBodyForces(view, ForceSource::Support, reaction, list);
}

/// All forces except inertia and mass-proportional damping.
ForceList allButInertia(const StepView& view, const Eigen::VectorXd& net) {
    ForceList list(view.model, view.state, moveOf(view.options));
    addLoads(view, list);
    addLinks(view, list);
    addReactions(view, net, list);
    return list;
}

/// Force of mass-proportional Rayleigh damping on every unknown [N].
Eigen::VectorXd massDamping(const StepView& view) {
    const Combination rate = factorsOf(view.options).rate;
    const Eigen::VectorXd motion = rate.d * view.d + rate.v * velocitiesOf(view.model, view.state) +
                                   rate.a * accelerationsOf(view.model, view.state);
    return -view.options.damping.mass * timesMass(view.model, motion);
}

/// Inertia force on every unknown [N]. If the scheme weights contact forces, it includes the difference due to the
/// weight.
Eigen::VectorXd inertiaOver(const StepView& view) {
    Eigen::VectorXd inertia = -inertiaForce(view.model, view.state, factorsOf(view.options), view.d);
    if (view.problem.contactShare != 1.0)
        inertia += (view.problem.contactShare - 1.0) * contactForce(view.problem, view.d);
    return inertia;
}

/// A step of zero length, with the friction limits that the forces at that moment allow.
StepProblem standing(const Model& model, const State& state, const Loads& loads, const LoadPoint& at,
                     const StepOptions& options) {
    StepProblem problem = buildStep(model, state, loads, at, options);
    correctFrictionLimits(problem, Eigen::VectorXd::Zero(problem.unknowns()));
    return problem;
}

}  // namespace

std::vector<SingleForce> forcesAtRest(const Model& model, const State& state, const Loads& loads, const LoadPoint& at) {
    const StepOptions options{Inertia::None};
    const StepProblem problem = standing(model, state, loads, at, options);
    const Eigen::VectorXd still = Eigen::VectorXd::Zero(problem.unknowns());
    return allButInertia({model, state, loads, at, options, problem, still}, netForce(problem, still)).take();
}

std::vector<SingleForce> forcesAtStart(const Model& model, const State& state, const Loads& loads, const LoadPoint& at,
                                       const Damping& damping) {
    const StepOptions options{Inertia::None, 1.0, false, 1.0, damping};
    const StepProblem problem = standing(model, state, loads, at, options);
    const Eigen::VectorXd still = Eigen::VectorXd::Zero(problem.unknowns());
    const StepView view{model, state, loads, at, options, problem, still};
    Eigen::VectorXd net = netForce(problem, still);
    ForceList list = allButInertia(view, net);
    for (Eigen::Index i = 0; i < net.size(); ++i)
        if (problem.known[i]) net[i] = 0.0;
    addBodyForces(view, ForceSource::Dashpot, massDamping(view), list);
    addBodyForces(view, ForceSource::Inertia, -net, list);
    return list.take();
}

std::vector<SingleForce> forcesOver(const Model& model, const Loads& loads, const TakenStep& step) {
    StepOptions options = step.options;
    if (step.path.size() > 0) options.path = &step.path;
    const StepView view{model, step.before, loads, step.at, options, step.problem, step.d};
    ForceList list = allButInertia(view, netForce(step.problem, step.d));
    addBodyForces(view, ForceSource::Dashpot, massDamping(view), list);
    addBodyForces(view, ForceSource::Inertia, inertiaOver(view), list);
    return list.take();
}

}  // namespace keyblock
