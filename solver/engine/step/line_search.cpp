// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/step/line_search.h"

#include "solver/engine/step/friction_limits.h"

#include <cassert>
#include <cmath>

namespace keyblock {
namespace {

constexpr double farthest = 4096.0;  // step length up to which resistance is looked for
constexpr int mostRootSweeps = 30;
constexpr double flatEnough = 1e-3;  // fraction of the slope at the start

/// Scalar product of the net force with a direction, times −1: the slope of the energy for given friction limits.
class LineSlope {
public:
    /// \param coupled true if the friction limits follow the forces along the line.
    LineSlope(StepProblem& problem, const LinkRows& rows, const Trial& from, const Eigen::VectorXd& direction,
              const std::vector<double>& rates, bool coupled)
        : problem_(problem), rows_(rows), strains_(from.strains), rates_(rates), coupled_(coupled),
          forces_(rates.size()) {
        takeBodies(from.d, direction);
        if (coupled) findBentPairs();
    }

    double at(double length) {
        double slope = constant_ + length * rate_;
        for (std::size_t i = 0; i < rates_.size(); ++i) {
            forces_[i] = forceOf(i, strains_[i] + length * rates_[i]);
            slope += rows_.law(i).share * forces_[i] * rates_[i];
        }
        return slope;
    }

    /// Sets the friction limits of the problem to those of the last length.
    void keepLimits() {
        if (!coupled_) return;
        for (const LimitPair& pair : problem_.limitPairs) setLimit(problem_, pair, forces_[pair.from]);
    }

private:
    void takeBodies(const Eigen::VectorXd& d, const Eigen::VectorXd& direction) {
        constant_ = -problem_.load.dot(direction.head(problem_.unknowns()));
        for (int i = 0; i < problem_.blocks; ++i) {
            const Vector6 rise = problem_.blockStiffness[i] * direction.segment<6>(6 * i);
            constant_ += rise.dot(d.segment<6>(6 * i));
            rate_ += rise.dot(direction.segment<6>(6 * i));
        }
        for (int i = 0; i < problem_.nodes; ++i) {
            const int at = problem_.first(problem_.blocks + i);
            const Eigen::Vector3d rise =
                problem_.nodeStiffness[i].cwiseProduct(direction.segment<3>(at));
            constant_ += rise.dot(d.segment<3>(at));
            rate_ += rise.dot(direction.segment<3>(at));
        }
    }

    void findBentPairs() {
        for (const LimitPair& pair : problem_.limitPairs) {
            assert(pair.from < pair.limited);
            if (!rows_.law(pair.limited).bounds.bent) continue;
            bentPairs_.resize(rates_.size(), nullptr);
            bentPairs_[pair.limited] = &pair;
        }
    }

    double forceOf(std::size_t i, double strain) {
        const FlatLaw& law = rows_.law(i);
        if (isBentAt(law, strain)) return bentForce(i, strain);
        if (!law.bounds.follows) return keyblock::forceOf(law, strain);
        const double most = coupled_ ? law.bounds.limit(forces_[i - 1]) : problem_.links[i].law.limit;
        return clipped(law.stiffness * (strain - law.offset), -most, most);
    }

    double bentForce(std::size_t i, double strain) {
        const LimitPair* pair = bentPairs_.empty() ? nullptr : bentPairs_[i];
        if (pair) setLimit(problem_, *pair, forces_[pair->from]);
        return respond(problem_, problem_.links[i], strain).force;
    }

    StepProblem& problem_;
    const LinkRows& rows_;
    const std::vector<double>&strains_, &rates_;
    bool coupled_;
    std::vector<const LimitPair*> bentPairs_;  // per link; null: its limit is fixed or follows the previous link
    std::vector<double> forces_;  // per link, not multiplied by `Law::share`
    double constant_ = 0.0, rate_ = 0.0;
};

/// The length at which the slope vanishes; `high` if it is still negative there.
double rootOf(LineSlope& slope, double high) {
    double low = 0.0;
    double atLow = slope.at(low), atHigh = slope.at(high);
    const double enough = flatEnough * std::abs(atLow);
    if (atLow >= 0.0 || atHigh <= enough) return high;
    for (int sweep = 0; sweep < mostRootSweeps; ++sweep) {  // regula falsi, Illinois
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

}  // namespace

double lineSearch(StepProblem& problem, const LinkRows& rows, const Trial& from, const Eigen::VectorXd& direction,
                  const std::vector<double>& rates, bool coupled) {
    LineSlope slope(problem, rows, from, direction, rates, coupled);
    const double length = rootOf(slope, 1.0);
    slope.keepLimits();
    return length;
}

std::optional<double> longLineSearch(StepProblem& problem, const LinkRows& rows, const Trial& from,
                                     const Eigen::VectorXd& direction, const std::vector<double>& rates) {
    LineSlope slope(problem, rows, from, direction, rates, true);
    double longest = 1.0;
    while (slope.at(longest) < 0.0) {
        longest *= 2.0;
        if (longest > farthest) return std::nullopt;
    }
    const double length = rootOf(slope, longest);
    slope.keepLimits();
    return length;
}

}  // namespace keyblock
