// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/stage/rest.h"

#include "solver/engine/step/step_forces.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace keyblock {
namespace {

// for strains of blocks, single cells and face plates: unbalanced force over the sum of the acting forces
constexpr double ofAllForces = 1e-3;
constexpr double ofNode = 1e-4;  // for bolt nodes: unbalanced force over the sum of the acting forces
constexpr double leastRestStrain = 1e-12;  // forces that cause smaller strains count as zero
constexpr double digits = 4.0 * std::numeric_limits<double>::epsilon();

/// Largest coordinate of a block centroid relative to the model's origin [m].
double largestCoordinate(const State& state) {
    double largest = 0.0;
    for (const BlockMotion& block : state.blocks) largest = std::max(largest, block.centroid.cwiseAbs().maxCoeff());
    return largest;
}

double leastForce(const Model& model, const BlockModel& block) {
    return leastRestStrain * block.youngsModulus * block.size * model.thickness;
}

/// Forces and stiffness of the links of each body.
struct LinkSums {
    std::vector<double> all;  // summed forces [N]
    std::vector<double> rock, others;  // largest force of a contact or of glue, and of any other link [N]
    std::vector<double> springs, outerSprings;  // Σ k² over all links, and without glue [N²/m²]

    explicit LinkSums(const StepProblem& problem) {
        const std::size_t bodies = problem.blocks + problem.nodes;
        all = rock = others = springs = outerSprings = std::vector<double>(bodies, 0.0);
        for (const Link& link : problem.links) {
            const double force = std::abs(respond(problem, link, link.strain + link.shift).force);
            add(problem, link, link.a, link.ga, force);
            if (link.b >= 0) add(problem, link, link.b, link.gb, force);
        }
    }

    void add(const StepProblem& problem, const Link& link, int body, const Vector6& gradient, double ofLaw) {
        const int width = problem.width(body);
        const auto weight = problem.weight.segment(problem.first(body), width);
        const double pull = link.law.share * gradient.head(width).cwiseProduct(weight).norm();
        const double force = pull * ofLaw;
        const double spring = pull * link.law.stiffness * gradient.head<2>().norm();
        const std::size_t at = body;
        double& largest = ofContact(link.kind) || link.kind == LinkKind::Glue ? rock[at] : others[at];
        largest = std::max(largest, force);
        all[at] += force;
        springs[at] += spring * spring;
        if (link.kind != LinkKind::Glue) outerSprings[at] += spring * spring;
    }
};

/// Reference force of a block: its weight; without gravity the largest of its other external forces, or if there are
/// none the largest contact force.
double ownForceOf(const Model& model, const StepProblem& problem, const LinkSums& sums, std::size_t block,
                  double weightPerMass) {
    const BlockModel& b = model.blocks[block];
    const double weight = b.mass * weightPerMass, least = leastForce(model, b);
    if (weight > 0.0) return weight;
    const double outside = std::max(problem.ownForce[block] - least, sums.others[block]);
    return outside > least ? outside : std::max(sums.rock[block], least);
}

/// Adds the reference forces of a bolt's nodes. A node with hardly any force is compared with the largest force in its
/// bolt, or with a fraction of the weight of the lightest block, because the unbalanced forces of nodes act on their
/// block.
void addNodeForces(const BoltModel& bolt, double lightest, const std::vector<double>& all, std::vector<double>& own) {
    const auto first = all.begin() + static_cast<std::ptrdiff_t>(own.size());
    const double largest = std::max(*std::max_element(first, first + static_cast<std::ptrdiff_t>(bolt.s.size())),
                                    lightest / static_cast<double>(bolt.s.size()));
    for (std::size_t n = 0; n < bolt.s.size(); ++n) {
        const double here = all[own.size()];
        own.push_back(here > ofNode * largest ? here : largest);
    }
}

/// Unbalanced force and moment about the centre of a body or of a block of several cells.
struct Left {
    Point force{0.0, 0.0};  // [N]
    double moment = 0.0;  // [N m]
};

class Judge {
public:
    Judge(const Model& model, const State& state, const StepProblem& problem, const RestForces& forces,
          const Eigen::VectorXd& net, double share)
        : model_(model), state_(state), problem_(problem), forces_(forces), net_(net), share_(share) {}

    Unrest judge() {
        for (std::size_t rock = 0; rock + 1 < model_.firstOf.size(); ++rock) judgeRock(model_.firstOf[rock], model_.firstOf[rock + 1]);
        for (int block = 0; block < problem_.blocks; ++block) judgeAlone(block);
        for (int node = problem_.blocks; node < problem_.blocks + problem_.nodes; ++node)
            compare(node, bodyResidual(problem_, net_, node), forces_.own[at(node)], ofNode, forces_.noise[at(node)]);
        return worst_;
    }

private:
    static std::size_t at(int body) { return body; }

    double free(Eigen::Index row) const { return problem_.known[row] ? 0.0 : net_[row]; }

    Left leftOn(int block) const {
        const Point& axis = state_.blocks[at(block)].axis;
        const Eigen::Index row = 6 * static_cast<Eigen::Index>(block);
        return {free(row) * axis + free(row + 1) * turnLeft(axis), free(row + 2)};
    }

    /// Checks a block, or all its cells as one: imbalance of glue forces between cells is not compared with the weight.
    void judgeRock(int first, int end) {
        double mass = 0.0, own = 0.0, noise = 0.0, hidden = 0.0, area = 0.0;
        Point middle{0.0, 0.0};
        for (int block = first; block < end; ++block) {
            const double m = model_.blocks[at(block)].mass;
            middle += m * state_.blocks[at(block)].centroid;
            mass += m;
            own += forces_.own[at(block)];
            noise += forces_.noise[at(block)];
            hidden += forces_.outerNoise[at(block)];
            area += model_.blocks[at(block)].area;
        }
        middle /= mass;
        Left sum;
        for (int block = first; block < end; ++block) {
            const Left left = leftOn(block);
            const Point arm = state_.blocks[at(block)].centroid - middle;
            sum.force += left.force;
            sum.moment += left.moment + arm.x() * left.force.y() - arm.y() * left.force.x();
        }
        compare(first, std::max(sum.force.norm(), std::abs(sum.moment) / std::sqrt(area)), own, share_, noise);
        const bool free = !model_.blocks[at(first)].fixed && !state_.blocks[at(first)].absent;
        if (!free || !forces_.weighs || hidden <= mostNoise * own) return;
        worst_.undecidable.push_back(first);
        worst_.noise = std::max(worst_.noise, hidden / own);
    }

    /// Checks the strains of a block, or everything for a cell or a face plate.
    void judgeAlone(int block) {
        const BlockModel& b = model_.blocks[at(block)];
        const Eigen::Index row = 6 * static_cast<Eigen::Index>(block);
        const double strains = Point(free(row + 3), free(row + 4)).norm() + std::abs(free(row + 5));
        double left = strains / b.size;
        if (b.cell || b.plateOf >= 0) left = bodyResidual(problem_, net_, block);
        compare(block, left, forces_.all[at(block)], ofAllForces, forces_.noise[at(block)]);
    }

    void compare(int body, double left, double reference, double share, double noise) {
        if (!(left > 0.0)) return;
        const double beyond = left / std::max(share * reference, noise);
        if (beyond > 1.0) worst_.restless.push_back(body);
        if (worst_.body >= 0 && beyond <= worst_.beyond) return;
        worst_.body = body;
        worst_.share = share_ / share * left / reference;
        worst_.force = left;
        worst_.beyond = beyond;
    }

    const Model& model_;
    const State& state_;
    const StepProblem& problem_;
    const RestForces& forces_;
    const Eigen::VectorXd& net_;
    double share_;
    Unrest worst_;
};

}  // namespace

RestForces restForces(const Model& model, const State& state, const StepProblem& problem, double weightPerMass) {
    RestForces forces;
    forces.weighs = weightPerMass > 0.0;
    const LinkSums sums(problem);
    const double place = largestCoordinate(state);
    for (double squares : sums.springs) forces.noise.push_back(digits * place * std::sqrt(squares));
    for (double squares : sums.outerSprings) forces.outerNoise.push_back(digits * place * std::sqrt(squares));
    forces.all = sums.all;
    for (std::size_t i = 0; i < forces.all.size(); ++i) forces.all[i] += problem.ownForce[i];
    for (std::size_t i = 0; i < model.blocks.size(); ++i) {
        const BlockModel& block = model.blocks[i];
        const double stress = frameStress(block, state.blocks[i]).cwiseAbs().maxCoeff();
        forces.all[i] += stress * block.size * model.thickness;
        const double own = ownForceOf(model, problem, sums, i, weightPerMass);
        forces.own.push_back(block.plateOf >= 0 ? std::max(own, forces.all[i]) : own);
    }
    const double lightest = *std::min_element(forces.own.begin(), forces.own.end());
    for (const BoltModel& bolt : model.bolts) addNodeForces(bolt, lightest, forces.all, forces.own);
    return forces;
}

Unrest farthestFromRest(const Model& model, const State& state, const StepProblem& problem, const RestForces& forces,
                        const Eigen::VectorXd& net, double share) {
    return Judge(model, state, problem, forces, net, share).judge();
}

}  // namespace keyblock
