// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Newton with exact line search on the step's convex energy, and around it the
// correction of the friction limits from the normal forces.
#include "solver/engine/step/step_problem.h"

#include "solver/engine/step/balance.h"
#include "solver/engine/step/friction_limits.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace keyblock {
namespace {

constexpr double quietStart = 1e-9;  // a start this well balanced needs no solve
constexpr int lineSearchSweeps = 30;
constexpr int patience = 2, boltPatience = 12;  // passes before a step is helped over flat laws of joints, and of bolts
constexpr double flatMatters = 1e-6;  // of the forces at play, unbalanced: joints are helped over no less
constexpr double lowestFloor = 1e-6, highestFloor = 0.1;  // of a law's stiffness

/// Slope of the energy along `direction`, from arrays of strains and their rates.
class LineSlope {
public:
    LineSlope(const StepProblem& problem, const Eigen::VectorXd& d, const Eigen::VectorXd& direction)
        : problem_(problem) {
        linkStrains(problem, d, strains_);
        linkStrains(problem, Eigen::VectorXd(d + direction), rates_);
        for (std::size_t i = 0; i < rates_.size(); ++i) rates_[i] -= strains_[i];
        constant_ = -problem.load.dot(direction);
        for (int i = 0; i < problem.blocks; ++i) {
            const Matrix6& k = problem.blockStiffness[static_cast<std::size_t>(i)];
            const Vector6 kd = k * direction.segment<6>(6 * i);
            constant_ += kd.dot(d.segment<6>(6 * i));
            rate_ += kd.dot(direction.segment<6>(6 * i));
        }
        for (int i = 0; i < problem.nodes; ++i) {
            const int at = problem.first(problem.blocks + i);
            const Eigen::Vector3d kd =
                problem.nodeStiffness[static_cast<std::size_t>(i)].cwiseProduct(direction.segment<3>(at));
            constant_ += kd.dot(d.segment<3>(at));
            rate_ += kd.dot(direction.segment<3>(at));
        }
    }

    double at(double alpha) const {
        double slope = constant_ + alpha * rate_;
        for (std::size_t i = 0; i < strains_.size(); ++i) {
            const Link& link = problem_.links[i];
            if (rates_[i] != 0.0)
                slope += link.law.share * respond(problem_, link, strains_[i] + alpha * rates_[i]).force * rates_[i];
        }
        return slope;
    }

private:
    const StepProblem& problem_;
    std::vector<double> strains_, rates_;
    double constant_ = 0.0, rate_ = 0.0;
};

/// Step length in (0, 1] at which the slope vanishes; 1 where it still falls there.
double lineSearch(const LineSlope& slope) {
    double low = 0.0, high = 1.0;
    double atLow = slope.at(low), atHigh = slope.at(high);
    const double enough = 1e-3 * std::abs(atLow);
    if (atLow >= 0.0 || atHigh <= enough) return 1.0;
    for (int sweep = 0; sweep < lineSearchSweeps; ++sweep) {  // regula falsi, Illinois
        const double middle = high - atHigh * (high - low) / (atHigh - atLow);
        const double atMiddle = slope.at(middle);
        if (std::abs(atMiddle) <= enough) return middle;
        if (atMiddle < 0.0) {
            low = middle, atLow = atMiddle, atHigh *= 0.5;
        } else {
            high = middle, atHigh = atMiddle, atLow *= 0.5;
        }
    }
    return low > 0.0 ? low : high;
}

/// Where laws are flat, of open joints too, a step of Newton's goes far and is stopped early by the first law that is
/// not: then laws are told stiffer than they are, until steps go through again.
double nextFloor(double floor, double stepLength) {
    if (stepLength < 0.05) return std::clamp(10.0 * floor, lowestFloor, highestFloor);
    if (stepLength > 0.5) return floor > lowestFloor ? 0.1 * floor : 0.0;
    return floor;
}

/// Nearly balanced, what is left of joints is friction at its limit to the last digits, where blocks slide to and fro.
LawFloor floorFrom(double floor, int passes, double residual) {
    return {passes > boltPatience ? floor : 0.0, residual > flatMatters ? floor : 0.0};
}

std::vector<std::pair<int, int>> bodyPairs(const StepProblem& problem) {
    std::vector<std::pair<int, int>> pairs;
    for (int body = 0; body < problem.blocks + problem.nodes; ++body) pairs.emplace_back(body, body);
    for (const Link& link : problem.links)
        if (link.b >= 0) pairs.emplace_back(std::max(link.a, link.b), std::min(link.a, link.b));
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    return pairs;
}

/// Longest translation by what is not prescribed [m].
double farthestMove(const StepProblem& problem, const Eigen::VectorXd& d) {
    double farthest = 0.0;
    for (int body = 0; body < problem.blocks + problem.nodes; ++body) {
        const int at = problem.first(body);
        const auto known = problem.known.begin() + at;
        if (known[0] || known[1]) continue;
        farthest = std::max(farthest, d.segment<2>(at).norm());
    }
    return farthest;
}

Balance judge(const StepProblem& problem, const Eigen::VectorXd& d, SolveReport& report) {
    Balance balance(problem, d, report.passes);
    report.residual = balance.residual();
    report.worst = balance.worst();
    return balance;
}

}  // namespace

double roundOffForce(const StepProblem& problem, const Eigen::VectorXd& d) {
    constexpr double digits = 8.0 * std::numeric_limits<double>::epsilon();
    double sum = 0.0;
    for (const Link& link : problem.links) {
        const int wa = problem.width(link.a);
        double size = std::abs(link.strain) +
                      link.ga.head(wa).cwiseAbs().dot(d.segment(problem.first(link.a), wa).cwiseAbs());
        if (link.b >= 0) {
            const int wb = problem.width(link.b);
            size += link.gb.head(wb).cwiseAbs().dot(d.segment(problem.first(link.b), wb).cwiseAbs());
        }
        const double force = digits * link.law.share * link.law.stiffness * size * link.ga.head<2>().norm();
        sum += force * force;
    }
    for (int i = 0; i < problem.blocks; ++i) {
        const Vector6 size = problem.blockStiffness[static_cast<std::size_t>(i)].cwiseAbs() *
                                 d.segment<6>(6 * i).cwiseAbs() + problem.load.segment<6>(6 * i).cwiseAbs();
        sum += (digits * size.cwiseProduct(problem.weight.segment<6>(6 * i))).squaredNorm();
    }
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

void StepSolver::fixPattern(const StepProblem& problem) {
    std::vector<std::pair<int, int>> pairs = bodyPairs(problem);
    const bool same = problem.known == known_ &&
                      std::includes(pairs_.begin(), pairs_.end(), pairs.begin(), pairs.end());
    if (same) return;
    known_ = problem.known;
    pairs_ = std::move(pairs);
    equations_.assign(static_cast<std::size_t>(problem.unknowns()), -1);
    unknownOf_.clear();
    for (int i = 0; i < problem.unknowns(); ++i) {
        if (known_[static_cast<std::size_t>(i)]) continue;
        equations_[static_cast<std::size_t>(i)] = static_cast<int>(unknownOf_.size());
        unknownOf_.push_back(i);
    }
    std::vector<std::pair<int, int>> entries;
    const auto eachEntry = [&](const std::pair<int, int>& pair, const auto& visit) {
        for (int i = 0; i < problem.width(pair.first); ++i)
            for (int j = 0; j < problem.width(pair.second); ++j) {
                const int row = equationOf(problem.first(pair.first) + i);
                const int col = equationOf(problem.first(pair.second) + j);
                if (row >= 0 && col >= 0 && row >= col) visit(6 * i + j, row, col);
            }
    };
    for (const auto& pair : pairs_)
        eachEntry(pair, [&](int, int row, int col) { entries.emplace_back(row, col); });
    system_.analyse(static_cast<int>(unknownOf_.size()), entries);
    slots_.assign(pairs_.size(), {});
    for (std::size_t p = 0; p < pairs_.size(); ++p) {
        slots_[p].fill(-1);
        eachEntry(pairs_[p], [&](int at, int row, int col) {
            slots_[p][static_cast<std::size_t>(at)] = system_.slot(row, col);
        });
    }
}

void StepSolver::assemble(const StepProblem& problem, const std::vector<double>& strains,
                          const LawFloor& floor) {
    system_.clear();
    const auto values = system_.values();
    const auto add = [&](int first, int second, const auto& block) {
        const auto found = std::lower_bound(pairs_.begin(), pairs_.end(), std::pair(first, second));
        const auto& slots = slots_[static_cast<std::size_t>(found - pairs_.begin())];
        for (int i = 0; i < block.rows(); ++i)
            for (int j = 0; j < block.cols(); ++j) {
                const int slot = slots[static_cast<std::size_t>(6 * i + j)];
                if (slot >= 0) values[static_cast<std::size_t>(slot)] += block(i, j);
            }
    };
    for (int i = 0; i < problem.blocks; ++i) add(i, i, problem.blockStiffness[static_cast<std::size_t>(i)]);
    for (int i = 0; i < problem.nodes; ++i)
        add(problem.blocks + i, problem.blocks + i,
            Eigen::Matrix3d(problem.nodeStiffness[static_cast<std::size_t>(i)].asDiagonal()));
    for (std::size_t i = 0; i < problem.links.size(); ++i) {
        const Link& link = problem.links[i];
        const double tangent = respond(problem, link, strains[i]).tangent;
        const double least = link.part >= 0 ? floor.bolts : floor.joints;
        const double k = link.law.share * std::max(tangent, least * link.law.stiffness);
        if (k == 0.0) continue;
        const auto ga = link.ga.head(problem.width(link.a));
        add(link.a, link.a, (k * ga * ga.transpose()).eval());
        if (link.b < 0) continue;
        const auto gb = link.gb.head(problem.width(link.b));
        add(link.b, link.b, (k * gb * gb.transpose()).eval());
        if (link.a >= link.b) add(link.a, link.b, (k * ga * gb.transpose()).eval());
        else add(link.b, link.a, (k * gb * ga.transpose()).eval());
    }
}

bool StepSolver::direction(const StepProblem& problem, const Eigen::VectorXd& d, const Eigen::VectorXd& net,
                           const LawFloor& floor, SolveReport& report, Eigen::VectorXd& towards) {
    std::vector<double> strains;
    linkStrains(problem, d, strains);
    assemble(problem, strains, floor);
    ++report.factorizations;
    if (const int loose = system_.factor(); loose >= 0) {
        report.singular = true;
        const int unknown = unknownOf_[static_cast<std::size_t>(loose)];
        report.worst = unknown < 6 * problem.blocks ? unknown / 6
                                                    : problem.blocks + (unknown - 6 * problem.blocks) / 3;
        return false;
    }
    Eigen::VectorXd right(static_cast<Eigen::Index>(unknownOf_.size())), step(right.size());
    for (Eigen::Index i = 0; i < right.size(); ++i) right[i] = net[unknownOf_[static_cast<std::size_t>(i)]];
    system_.solve({right.data(), static_cast<std::size_t>(right.size())},
                  {step.data(), static_cast<std::size_t>(step.size())});
    towards = Eigen::VectorXd::Zero(problem.unknowns());
    for (Eigen::Index i = 0; i < step.size(); ++i) towards[unknownOf_[static_cast<std::size_t>(i)]] = step[i];
    return true;
}

SolveReport StepSolver::solve(StepProblem& problem, Eigen::VectorXd& d, const SolveSettings& settings,
                              const std::function<bool()>& stopAsked) {
    for (int i = 0; i < problem.unknowns(); ++i)
        if (problem.known[static_cast<std::size_t>(i)]) d[i] = problem.value[i];
    fixPattern(problem);
    return settings.openClose ? openClose(problem, d, settings, stopAsked) : minimise(problem, d, settings, stopAsked);
}

SolveReport StepSolver::minimise(StepProblem& problem, Eigen::VectorXd& d, const SolveSettings& settings,
                                 const std::function<bool()>& stopAsked) {
    SolveReport report;
    Eigen::VectorXd towards;
    LimitRounds rounds;
    double floor = 0.0;
    for (; report.passes <= settings.maxPasses; ++report.passes) {
        if (stopAsked && stopAsked()) {
            report.stopped = true;
            return report;
        }
        Balance balance = judge(problem, d, report);
        if (!std::isfinite(report.residual)) return report;
        const double tolerance = report.passes == 0 ? std::min(quietStart, settings.tolerance) : settings.tolerance;
        if (balance.within(tolerance)) {  // under the limits assumed: now under the true ones
            rounds.correct(problem, d);
            balance = judge(problem, d, report);
            report.converged = balance.within(tolerance);
            if (report.converged) return report;
            if (rounds.mix(problem)) balance = judge(problem, d, report);
        }
        const LawFloor floors = floorFrom(floor, report.passes, report.residual);
        if (!direction(problem, d, balance.net(), floors, report, towards)) {
            floor = std::max(floor, lowestFloor);
            if (!direction(problem, d, balance.net(), {floor, floor}, report, towards)) return report;
        }
        const double stepLength = lineSearch(LineSlope(problem, d, towards));
        d += stepLength * towards;
        if (report.passes < patience) continue;
        floor = nextFloor(floor, stepLength);
        report.lost = farthestMove(problem, d) > settings.farthest;
        if (report.lost) return report;
    }
    return report;
}

}  // namespace keyblock
