// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/step/line_search.h"

#include "solver/engine/step/flat_law.h"
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
    LineSlope(StepProblem& problem, const Trial& from, const Eigen::VectorXd& direction,
              const std::vector<double>& rates, bool coupled)
        : problem_(problem) {
        takeBodies(from.d, direction);
        takeLinks(from.strains, rates, coupled);
    }

    double at(double length) {
        double slope = constant_ + length * rate_;
        for (std::size_t n = 0; n < rows_.size(); ++n) {
            const Row& row = rows_[n];
            forces_[n] = row.from < 0 ? forceOf(row, length, row.law.bounds.low, row.law.bounds.high)
                                      : limitedForce(row, length, forces_[row.from]);
            slope += row.share * forces_[n] * row.rate;
        }
        return slope;
    }

    /// Sets the friction limits of the problem to those of the last length.
    void keepLimits() {
        for (const int n : followers_) {
            const Row& row = rows_[n];
            setLimit(problem_, problem_.limitPairs[row.pair], forces_[row.from]);
        }
    }

private:
    struct Row {
        double strain = 0.0, rate = 0.0, share = 1.0;
        FlatLaw law;
        int link = -1;
        int from = -1, pair = -1;  // earlier row whose force sets the limit, and row of limitPairs; −1: fixed limit
    };

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

    void takeLinks(const std::vector<double>& strains, const std::vector<double>& rates, bool coupled) {
        rows_.reserve(rates.size());
        for (std::size_t i = 0; i < rates.size(); ++i) {
            const Link& link = problem_.links[i];
            rows_.push_back({strains[i], rates[i], link.law.share, flatLaw(problem_, link), static_cast<int>(i), -1, -1});
        }
        forces_.resize(rows_.size());
        for (std::size_t p = 0; coupled && p < problem_.limitPairs.size(); ++p) {
            const LimitPair& pair = problem_.limitPairs[p];
            assert(pair.from < pair.limited);
            Row& row = rows_[pair.limited];
            row.law = flatLaw(problem_, pair);
            row.from = pair.from;
            row.pair = static_cast<int>(p);
            followers_.push_back(pair.limited);
        }
    }

    double forceOf(const Row& row, double length, double low, double high) const {
        const double strain = row.strain + length * row.rate;
        if (row.law.bounds.bent) return respond(problem_, problem_.links[row.link], strain).force;
        return clipped(row.law.stiffness * (strain - row.law.offset), low, high);
    }

    double limitedForce(const Row& row, double length, double from) {
        if (row.law.bounds.bent) setLimit(problem_, problem_.limitPairs[row.pair], from);
        const double most = row.law.bounds.limit(from);
        return forceOf(row, length, -most, most);
    }

    StepProblem& problem_;
    std::vector<Row> rows_;  // one per link
    std::vector<int> followers_;  // rows in the order of limitPairs
    std::vector<double> forces_;  // not multiplied by `Law::share`
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

double lineSearch(StepProblem& problem, const Trial& from, const Eigen::VectorXd& direction,
                  const std::vector<double>& rates, bool coupled) {
    LineSlope slope(problem, from, direction, rates, coupled);
    const double length = rootOf(slope, 1.0);
    slope.keepLimits();
    return length;
}

std::optional<double> longLineSearch(StepProblem& problem, const Trial& from, const Eigen::VectorXd& direction,
                                     const std::vector<double>& rates) {
    LineSlope slope(problem, from, direction, rates, true);
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
