// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Forces of a step at a trial displacement. Links are evaluated in parallel, each into
// its own element; sums are formed in the order of the links, so that results do not
// depend on the number of threads.
#include "solver/engine/step/step_forces.h"

#include "solver/engine/step/parallel.h"

#include <algorithm>
#include <cmath>

namespace keyblock {
namespace {

constexpr std::size_t strainsATask = 4096;

Eigen::VectorXd linkForces(const StepProblem& problem, const Eigen::VectorXd& d, std::vector<double>& forces) {
    std::vector<double> strains;
    linkStrains(problem, d, strains);
    forces.resize(strains.size());
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(problem.unknowns());
    for (std::size_t i = 0; i < strains.size(); ++i) {
        const Link& link = problem.links[i];
        forces[i] = link.law.share * respond(problem, link, strains[i]).force;
        const int wa = problem.width(link.a);
        sum.segment(problem.first(link.a), wa) += forces[i] * link.ga.head(wa);
        if (link.b < 0) continue;
        const int wb = problem.width(link.b);
        sum.segment(problem.first(link.b), wb) += forces[i] * link.gb.head(wb);
    }
    return sum;
}

/// \param forces the forces of the links, multiplied by `Law::share`.
double largestSum(const StepProblem& problem, const std::vector<double>& forces, const Eigen::VectorXd& net) {
    double contact = 0.0, bolt = 0.0, reaction = 0.0;
    for (std::size_t i = 0; i < forces.size(); ++i) {
        const LinkKind kind = problem.links[i].kind;
        if (ofContact(kind)) contact += std::abs(forces[i]);
        else if (kind == LinkKind::Glue) continue;  // acts within a block, like its stress
        else if (kind == LinkKind::Support) reaction += std::abs(forces[i]);
        else if (kind != LinkKind::Bend && kind != LinkKind::Shear && kind != LinkKind::Drag) bolt += std::abs(forces[i]);
    }
    for (int i = 0; i < problem.unknowns(); ++i)
        if (problem.known[i]) reaction += std::abs(net[i]) * problem.weight[i];
    return std::max({problem.externalForce, reaction, contact, bolt, problem.floorForce});
}

double squaredResidual(const StepProblem& problem, const Eigen::VectorXd& net, int body) {
    double sum = 0.0;
    for (int k = problem.first(body); k < problem.first(body) + problem.width(body); ++k) {
        if (problem.known[k]) continue;
        const double r = net[k] * problem.weight[k];
        sum += r * r;
    }
    return sum;
}

}  // namespace

void linkStrains(const StepProblem& problem, const Eigen::VectorXd& d, std::vector<double>& strains) {
    strains.resize(problem.links.size());
    const auto one = [&](std::size_t i) {
        const Link& link = problem.links[i];
        const int wa = problem.width(link.a);
        double e = link.strain + link.shift + link.ga.head(wa).dot(d.segment(problem.first(link.a), wa));
        if (link.b >= 0) {
            const int wb = problem.width(link.b);
            e += link.gb.head(wb).dot(d.segment(problem.first(link.b), wb));
        }
        strains[i] = e;
    };
    if (strains.size() < 2 * strainsATask) {
        for (std::size_t i = 0; i < strains.size(); ++i) one(i);
        return;
    }
    inParallel(strains.size(), strainsATask, one);
}

Eigen::VectorXd netForce(const StepProblem& problem, const Eigen::VectorXd& d) {
    std::vector<double> forces;
    Eigen::VectorXd net = problem.load - linkForces(problem, d, forces);
    for (int i = 0; i < problem.blocks; ++i)
        net.segment<6>(6 * i) -= problem.blockStiffness[i] * d.segment<6>(6 * i);
    for (int i = 0; i < problem.nodes; ++i) {
        const int at = problem.first(problem.blocks + i);
        net.segment<3>(at) -= problem.nodeStiffness[i].cwiseProduct(d.segment<3>(at));
    }
    return net;
}

Eigen::VectorXd contactForce(const StepProblem& problem, const Eigen::VectorXd& d) {
    std::vector<double> strains;
    linkStrains(problem, d, strains);
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(problem.unknowns());
    for (std::size_t i = 0; i < strains.size(); ++i) {
        const Link& link = problem.links[i];
        if (!ofContact(link.kind)) continue;
        const double force = link.law.share * respond(problem, link, strains[i]).force / problem.contactShare;
        sum.segment<6>(problem.first(link.a)) -= force * link.ga;
        sum.segment<6>(problem.first(link.b)) -= force * link.gb;
    }
    return sum;
}

double referenceForce(const StepProblem& problem, const Eigen::VectorXd& d, const Eigen::VectorXd& net) {
    std::vector<double> forces;
    linkForces(problem, d, forces);
    return largestSum(problem, forces, net);
}

double bodyResidual(const StepProblem& problem, const Eigen::VectorXd& net, int body) {
    return std::sqrt(squaredResidual(problem, net, body));
}

double residualNorm(const StepProblem& problem, const Eigen::VectorXd& net) {
    double sum = 0.0;
    for (int body = 0; body < problem.blocks + problem.nodes; ++body) sum += squaredResidual(problem, net, body);
    return std::sqrt(sum);
}

double placeNoise(const StepProblem& problem, double length) {
    double sum = 0.0;
    for (const Link& link : problem.links) {
        const double force = link.law.share * link.law.stiffness * length * link.ga.head<2>().squaredNorm();
        sum += force * force;
    }
    return std::sqrt(sum);
}

}  // namespace keyblock
