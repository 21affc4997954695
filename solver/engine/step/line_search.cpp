// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/step/line_search.h"

#include "solver/engine/step/friction_limits.h"

#include <cmath>

namespace keyblock {
namespace {

constexpr int mostSweeps = 30;
constexpr double flatEnough = 1e-3;  // of the slope at the start

/// What the net force does along a direction, times −1: the slope of the energy for given friction limits.
class LineSlope {
public:
    LineSlope(StepProblem& problem, const Trial& from, const Eigen::VectorXd& direction,
              const std::vector<double>& rates, bool coupled)
        : problem_(problem), coupled_(coupled), forces_(rates.size()), strains_(from.strains), rates_(rates) {
        constant_ = -problem.load.dot(direction.head(problem.unknowns()));
        for (int i = 0; i < problem.blocks; ++i) {
            const Vector6 rise = problem.blockStiffness[static_cast<std::size_t>(i)] * direction.segment<6>(6 * i);
            constant_ += rise.dot(from.d.segment<6>(6 * i));
            rate_ += rise.dot(direction.segment<6>(6 * i));
        }
        for (int i = 0; i < problem.nodes; ++i) {
            const int at = problem.first(problem.blocks + i);
            const Eigen::Vector3d rise =
                problem.nodeStiffness[static_cast<std::size_t>(i)].cwiseProduct(direction.segment<3>(at));
            constant_ += rise.dot(from.d.segment<3>(at));
            rate_ += rise.dot(direction.segment<3>(at));
        }
    }

    double at(double length) {
        const auto forceOf = [&](std::size_t i) {
            const Link& link = problem_.links[i];
            return respond(problem_, link, strains_[i] + length * rates_[i]).force;
        };
        for (std::size_t i = 0; i < rates_.size(); ++i) forces_[i] = forceOf(i);
        for (std::size_t p = 0; coupled_ && p < problem_.limitPairs.size(); ++p) {
            const LimitPair& pair = problem_.limitPairs[p];
            setLimit(problem_, pair, forces_[static_cast<std::size_t>(pair.from)]);
            forces_[static_cast<std::size_t>(pair.limited)] = forceOf(static_cast<std::size_t>(pair.limited));
        }
        double slope = constant_ + length * rate_;
        for (std::size_t i = 0; i < rates_.size(); ++i) slope += problem_.links[i].law.share * forces_[i] * rates_[i];
        return slope;
    }

private:
    StepProblem& problem_;
    bool coupled_;
    std::vector<double> forces_;  // before shares
    const std::vector<double>&strains_, &rates_;
    double constant_ = 0.0, rate_ = 0.0;
};

}  // namespace

double lineSearch(StepProblem& problem, const Trial& from, const Eigen::VectorXd& direction,
                  const std::vector<double>& rates, bool coupled) {
    LineSlope slope(problem, from, direction, rates, coupled);
    double low = 0.0, high = 1.0;
    double atLow = slope.at(low), atHigh = slope.at(high);
    const double enough = flatEnough * std::abs(atLow);
    if (atLow >= 0.0 || atHigh <= enough) return 1.0;
    for (int sweep = 0; sweep < mostSweeps; ++sweep) {  // regula falsi, Illinois
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

}  // namespace keyblock
