// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/verify/reference/bar.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace keyblock::reference {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();
constexpr double flattest = 1e-7;  // of the first slope

/// A scalar law between degrees of freedom.
struct Device {
    std::vector<std::pair<int, double>> gradient;  // deformation = Σ coefficient · freedom
    Curve curve;
    std::optional<double> peak;
    double residual = 0.0;
    double lastDeformation = never;
    int spring = -1, element = -1;

    double deformation = 0.0, force = 0.0;
    std::size_t piece = 0;  // of the yield curve
    double accumulated = 0.0;  // plastic deformation
    double yield = never;
    bool plastic = false;
    bool released = false;

    double firstSlope() const { return curve.front().second / curve.front().first; }
    double plasticAt(std::size_t i) const { return curve[i].first - curve[i].second / firstSlope(); }
    bool lastPiece() const { return piece + 1 >= curve.size(); }
    double slope() const {
        if (released) return 0.0;
        if (!plastic) return firstSlope();
        if (lastPiece()) return flattest * firstSlope();
        const double rise = (curve[piece + 1].second - curve[piece].second) /
                            (curve[piece + 1].first - curve[piece].first);
        return std::max(rise, flattest * firstSlope());
    }
    /// Keeps `after` from now on; as friction it may unload again.
    void letGo(double after, bool restick) {
        force = after;
        peak.reset();
        released = !restick;
        if (!restick) return;
        const double slip = std::abs(after) / firstSlope();
        curve = {{slip, std::abs(after)}, {slip + 1.0, std::abs(after)}};
        yield = std::abs(after);
        plastic = true;
    }
    double along(const Eigen::VectorXd& q) const {
        double e = 0.0;
        for (const auto& [i, c] : gradient) e += c * q(i);
        return e;
    }
};

class Model {
public:
    explicit Model(const BarProblem& problem);

    void run(double target, bool byLoad, BarResult& result);

private:
    Eigen::VectorXd solve(const Eigen::VectorXd& load, double centreRate, bool byLoad) const;
    Eigen::VectorXd consistentRates(const Eigen::VectorXd& load, double centreRate, bool byLoad);
    bool correctBranches(const Eigen::VectorXd& rate);
    double stepTo(const Device& device, double rate, bool limitsCount) const;
    void move(const Eigen::VectorXd& rate, double step);
    void turnCorners();
    /// Carries the model by `amount`; false when a limit stops it.
    bool advance(const Eigen::VectorXd& load, double centreRate, bool byLoad, double amount, bool limitsCount,
                 BarResult& result);
    bool releaseOverloaded(bool byLoad, BarResult& result);
    int mostOverloaded(double atLeast) const;
    void note(BarResult& result) const { result.path.emplace_back(opening(), load()); }
    double load() const;
    double opening() const;

    BarProblem problem_;
    std::vector<Device> devices_;
    Eigen::VectorXd q_;
    int centre_ = 0, strain_ = -1;
    double done_ = 0.0;
};

Model::Model(const BarProblem& problem) : problem_(problem) {
    const int nodes = static_cast<int>(problem.s.size());
    centre_ = nodes;
    strain_ = problem.blockStiffness ? nodes + 1 : -1;
    q_ = Eigen::VectorXd::Zero(nodes + (strain_ >= 0 ? 2 : 1));
    for (int i = 0; i + 1 < nodes; ++i) {
        Device bar;
        const double length = problem.s[i + 1] - problem.s[i];
        for (const auto& [strain, stress] : problem.steel)
            bar.curve.emplace_back(strain * length, stress * problem.area);
        bar.gradient = {{i, -1.0}, {i + 1, 1.0}};
        bar.element = i;
        if (problem.breaksAt) bar.peak = problem.breaksAt;
        else if (!problem.unbreakable) bar.lastDeformation = bar.curve.back().first;
        devices_.push_back(bar);
    }
    for (std::size_t i = 0; i < problem.springs.size(); ++i) {
        const BarSpring& from = problem.springs[i];
        Device spring;
        spring.curve = from.curve;
        spring.peak = from.peak;
        spring.residual = from.residual;
        spring.spring = static_cast<int>(i);
        spring.gradient = {{from.node, -1.0}};
        if (from.side == Side::Moving) {
            spring.gradient.emplace_back(centre_, 1.0);
            const double arm = problem.s[from.node] - problem.blockCentre;
            if (strain_ >= 0) spring.gradient.emplace_back(strain_, arm);
        }
        devices_.push_back(spring);
    }
    if (strain_ >= 0) {
        Device block;
        block.curve = {{1.0, *problem.blockStiffness}};
        block.gradient = {{strain_, 1.0}};
        devices_.push_back(block);
    }
    for (Device& device : devices_)
        if (device.curve.size() > 1) device.yield = device.curve.front().second;
}

Eigen::VectorXd Model::solve(const Eigen::VectorXd& load, double centreRate, bool byLoad) const {
    Eigen::MatrixXd k = Eigen::MatrixXd::Zero(q_.size(), q_.size());
    for (const Device& device : devices_)
        for (const auto& [i, a] : device.gradient)
            for (const auto& [j, b] : device.gradient) k(i, j) += device.slope() * a * b;
    Eigen::VectorXd f = load;
    if (!byLoad) {
        f -= k.col(centre_) * centreRate;
        k.row(centre_).setZero();
        k.col(centre_).setZero();
        k(centre_, centre_) = 1.0;
        f(centre_) = centreRate;
    }
    const Eigen::LDLT<Eigen::MatrixXd> factor(k);
    Eigen::VectorXd q = factor.solve(f);
    q += factor.solve(f - k * q);
    return q;
}

bool Model::correctBranches(const Eigen::VectorXd& rate) {
    bool changed = false;
    for (Device& device : devices_) {
        if (device.released || device.yield == never) continue;
        const double e = device.along(rate);
        const bool outward = e * device.force > 0.0;
        const bool atYield = std::abs(device.force) >= device.yield * (1.0 - 1e-12);
        const bool should = atYield && outward;
        if (should != device.plastic && std::abs(e) > 1e-14 * rate.cwiseAbs().maxCoeff()) {
            device.plastic = should;
            changed = true;
        }
    }
    return changed;
}

Eigen::VectorXd Model::consistentRates(const Eigen::VectorXd& load, double centreRate, bool byLoad) {
    for (int tries = 0; tries < 100; ++tries) {
        Eigen::VectorXd rate = solve(load, centreRate, byLoad);
        if (!correctBranches(rate)) return rate;
    }
    throw std::runtime_error("no consistent branches");
}

double Model::stepTo(const Device& device, double rate, bool limitsCount) const {
    if (device.released) return never;
    const double sign = rate < 0.0 ? -1.0 : 1.0;
    const double forceRate = device.slope() * rate;
    double step = never;
    if (!device.plastic && device.yield != never && forceRate != 0.0)
        step = std::min(step, (sign * device.yield - device.force) / forceRate);
    if (device.plastic && !device.lastPiece()) {
        const double plasticRate = std::abs(rate) * (1.0 - device.slope() / device.firstSlope());
        step = std::min(step, (device.plasticAt(device.piece + 1) - device.accumulated) / plasticRate);
    }
    if (limitsCount && device.peak && forceRate != 0.0)
        step = std::min(step, (sign * *device.peak - device.force) / forceRate);
    if (limitsCount && device.lastDeformation != never && rate != 0.0)
        step = std::min(step, (sign * device.lastDeformation - device.deformation) / rate);
    return std::max(step, 0.0);
}

void Model::move(const Eigen::VectorXd& rate, double step) {
    q_ += step * rate;
    for (Device& device : devices_) {
        const double e = step * device.along(rate);
        device.deformation += e;
        if (device.released) continue;
        device.force += device.slope() * e;
        if (!device.plastic) continue;
        device.accumulated += std::abs(e) * (1.0 - device.slope() / device.firstSlope());
        device.yield = std::abs(device.force);
    }
}

void Model::turnCorners() {
    for (Device& device : devices_) {
        if (!device.plastic || device.lastPiece()) continue;
        const double corner = device.plasticAt(device.piece + 1);
        if (device.accumulated >= corner * (1.0 - 1e-12)) ++device.piece;
    }
}

bool Model::advance(const Eigen::VectorXd& load, double centreRate, bool byLoad, double amount, bool limitsCount,
                    BarResult& result) {
    double left = amount;
    const double least = 1e-13 * amount;
    while (left > least) {
        const Eigen::VectorXd rate = consistentRates(load, centreRate, byLoad);
        double step = left;
        const Device* first = nullptr;
        for (const Device& device : devices_) {
            const double to = stepTo(device, device.along(rate), limitsCount);
            if (to < step) {
                step = to;
                first = &device;
            }
        }
        move(rate, step);
        left -= step;
        if (limitsCount) {
            done_ += step;
            note(result);
            if (mostOverloaded(1.0 - 1e-12) >= 0) return false;
            for (const Device& device : devices_)
                if (std::abs(device.deformation) >= device.lastDeformation * (1.0 - 1e-12)) return false;
        }
        if (first && limitsCount && first->element >= 0 && !first->plastic)
            result.events.push_back({BarEventKind::Corner, -1, first->element, false, this->load(), this->load(),
                                     opening()});
        turnCorners();
    }
    return true;
}

/// Index of the spring to go next, or −1: the largest ratio of force to strength, in a tie the lowest node.
int Model::mostOverloaded(double atLeast) const {
    double largest = 0.0;
    for (const Device& d : devices_)
        if (d.peak && !d.released) largest = std::max(largest, std::abs(d.force) / *d.peak);
    if (largest < atLeast) return -1;
    int chosen = -1;
    double chosenPlace = never;
    for (std::size_t i = 0; i < devices_.size(); ++i) {
        const Device& d = devices_[i];
        if (!d.peak || d.released || std::abs(d.force) / *d.peak < largest * (1.0 - 1e-6)) continue;
        double place = d.element + 0.5;
        if (d.spring >= 0) {
            const BarSpring& spring = problem_.springs[d.spring];
            place = spring.node + (spring.plate ? 0.25 : 0.0);
        }
        if (place >= chosenPlace) continue;
        chosen = static_cast<int>(i);
        chosenPlace = place;
    }
    return chosen;
}

/// Lets the springs over their limit go one after another. \return false when the steel broke.
bool Model::releaseOverloaded(bool byLoad, BarResult& result) {
    for (int next = mostOverloaded(1.0 - 1e-12); next >= 0; next = mostOverloaded(1.0 + 1e-9)) {
        Device& device = devices_[next];
        BarEvent event{BarEventKind::Rupture, -1, device.element, false, load(), 0.0, opening()};
        if (device.element >= 0) {
            result.events.push_back(event);
            return false;
        }
        const BarSpring& spring = problem_.springs[device.spring];
        event.kind = BarEventKind::Release;
        event.node = spring.node;
        event.plate = spring.plate;
        const double after = std::copysign(device.residual, device.force);
        Eigen::VectorXd drop = Eigen::VectorXd::Zero(q_.size());
        for (const auto& [i, c] : device.gradient) drop(i) += (device.force - after) * c;
        device.letGo(after, spring.restick);
        advance(drop, 0.0, byLoad, 1.0, false, result);
        event.loadAfter = load();
        result.events.push_back(event);
        note(result);
    }
    return true;
}

void Model::run(double target, bool byLoad, BarResult& result) {
    Eigen::VectorXd unit = Eigen::VectorXd::Zero(q_.size());
    if (byLoad) unit(centre_) = 1.0;
    note(result);
    while (done_ < target * (1.0 - 1e-13)) {
        if (advance(unit, byLoad ? 0.0 : 1.0, byLoad, target - done_, true, result)) break;
        if (byLoad && mostOverloaded(1.0 - 1e-12) >= 0) break;
        if (mostOverloaded(1.0 - 1e-12) < 0) {
            for (const Device& d : devices_)
                if (std::abs(d.deformation) >= d.lastDeformation * (1.0 - 1e-12)) {
                    result.events.push_back({BarEventKind::Rupture, -1, d.element, false, load(), 0.0, opening()});
                    break;
                }
            break;
        }
        if (!releaseOverloaded(byLoad, result)) break;
    }
    for (const Device& d : devices_) {
        if (d.element >= 0) result.elementForce.push_back(d.force);
        if (d.spring >= 0) result.springForce.push_back(d.force);
    }
}

double Model::load() const {
    double sum = 0.0;
    for (const Device& d : devices_)
        if (d.spring >= 0 && problem_.springs[d.spring].side == Side::Moving) sum += d.force;
    return sum;
}

double Model::opening() const {
    const double strain = strain_ >= 0 ? q_(strain_) : 0.0;
    return q_(centre_) + strain * (problem_.openingAt - problem_.blockCentre);
}

}  // namespace

std::vector<BarEvent> BarResult::releases() const {
    std::vector<BarEvent> only;
    for (const BarEvent& event : events)
        if (event.kind == BarEventKind::Release) only.push_back(event);
    return only;
}

double BarResult::largestLoad() const {
    double largest = 0.0;
    for (const auto& [opening, load] : path) largest = std::max(largest, load);
    return largest;
}

double BarResult::openingAtLargestLoad() const {
    const auto most = std::max_element(path.begin(), path.end(),
                                       [](const auto& a, const auto& b) { return a.second < b.second; });
    return most->first;
}

double BarResult::loadAt(double opening) const {
    for (std::size_t i = 1; i < path.size(); ++i) {
        const auto& [x0, y0] = path[i - 1];
        const auto& [x1, y1] = path[i];
        if (x0 <= opening && opening <= x1 && x1 > x0) return y0 + (y1 - y0) * (opening - x0) / (x1 - x0);
    }
    return path.back().second;
}

std::optional<BarEvent> BarResult::first(BarEventKind kind) const {
    for (const BarEvent& event : events)
        if (event.kind == kind) return event;
    return std::nullopt;
}

BarResult pullTo(const BarProblem& problem, double displacement) {
    BarResult result;
    Model(problem).run(displacement, false, result);
    return result;
}

BarResult loadTo(const BarProblem& problem, double force) {
    BarResult result;
    Model(problem).run(force, true, result);
    return result;
}

}  // namespace keyblock::reference
