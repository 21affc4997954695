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

constexpr std::size_t linksOfTask = 4096;

/// Product of a link's gradient and the displacement of one of its bodies, which has six unknowns or three. Two sums
/// in parallel use the processor better than one.
double strainDueTo(const Vector6& gradient, const double* d, bool isBlock) {
    const double* g = gradient.data();
    if (!isBlock) return g[0] * d[0] + g[1] * d[1] + g[2] * d[2];
    const double even = g[0] * d[0] + g[2] * d[2] + g[4] * d[4], odd = g[1] * d[1] + g[3] * d[3] + g[5] * d[5];
    return even + odd;
}

void addForce(double force, const Vector6& gradient, double* sum, bool isBlock) {
    const int width = isBlock ? 6 : 3;
    for (int k = 0; k < width; ++k) sum[k] += force * gradient[k];
}

/// Forces of the links at strains `strains`, multiplied by `Law::share`.
std::vector<double> forcesAt(const StepProblem& problem, const std::vector<double>& strains) {
    std::vector<double> forces(strains.size());
    forEach(strains.size(), linksOfTask, [&](std::size_t i) {
        const Link& link = problem.links[i];
        forces[i] = link.law.share * respond(problem, link, strains[i]).force;
    });
    return forces;
}

Eigen::VectorXd sumOfForces(const StepProblem& problem, const std::vector<double>& forces) {
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(problem.unknowns());
    for (std::size_t i = 0; i < forces.size(); ++i) {
        const Link& link = problem.links[i];
        addForce(forces[i], link.ga, sum.data() + problem.first(link.a), link.a < problem.blocks);
        if (link.b >= 0) addForce(forces[i], link.gb, sum.data() + problem.first(link.b), link.b < problem.blocks);
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

double linkStrain(const StepProblem& problem, const Link& link, const Eigen::VectorXd& d) {
    double e = link.strain + link.shift +
               strainDueTo(link.ga, d.data() + problem.first(link.a), link.a < problem.blocks);
    if (link.b >= 0) e += strainDueTo(link.gb, d.data() + problem.first(link.b), link.b < problem.blocks);
    return e;
}

void linkStrains(const StepProblem& problem, const Eigen::VectorXd& d, std::vector<double>& strains) {
    strains.resize(problem.links.size());
    forEach(strains.size(), linksOfTask, [&](std::size_t i) { strains[i] = linkStrain(problem, problem.links[i], d); });
}

Eigen::VectorXd netForce(const StepProblem& problem, const Eigen::VectorXd& d) {
    std::vector<double> strains;
    linkStrains(problem, d, strains);
    return netForce(problem, d, strains);
}

Eigen::VectorXd netForce(const StepProblem& problem, const Eigen::VectorXd& d, const std::vector<double>& strains) {
    Eigen::VectorXd net = problem.load - sumOfForces(problem, forcesAt(problem, strains));
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
    std::vector<double> strains;
    linkStrains(problem, d, strains);
    return largestSum(problem, forcesAt(problem, strains), net);
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
