// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/properties/isometry.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <tuple>
#include <vector>

namespace keyblock {
namespace {

Stress turned(const Eigen::Matrix2d& q, const Stress& stress) {
    Eigen::Matrix2d s;
    s << stress[0], stress[2], stress[2], stress[1];
    s = q * s * q.transpose();
    return {s(0, 0), s(1, 1), s(0, 1)};
}

template <class Place, class Direction>
void changeStage(Stage& stage, bool mirror, Place place, Direction direction) {
    for (Motion& motion : stage.motions) {
        place(motion.blockAt);
        direction(motion.axis);
    }
    for (Load& load : stage.loads) {
        if (load.blockAt) place(*load.blockAt);
        if (load.at) place(*load.at);
        if (load.point) place(*load.point);
        if (load.along) std::for_each(load.along->begin(), load.along->end(), place);
        direction(load.force);
    }
    for (std::optional<Acceleration>* acceleration : {&stage.baseAcceleration, &stage.bodyAcceleration})
        if (*acceleration) direction((*acceleration)->axis);
    for (InitialVelocity& initial : stage.initialVelocities) {
        place(initial.blockAt);
        direction(initial.velocity);
        if (mirror) initial.spin = -initial.spin;
    }
}

/// Row of each block of `own` in `seen`: cells of a block may be numbered from its other end.
std::vector<int> rowsThrough(const Eigen::Matrix2d& q, const Frame& own, const Frame& seen) {
    std::vector<int> rows;
    const auto start = [](const BlockState& b) -> Point { return b.centroid - b.displacement; };
    for (const BlockState& block : own.blocks) {
        const Point place = q * start(block);
        const auto nearer = [&](const BlockState& x, const BlockState& y) {
            return (start(x) - place).norm() < (start(y) - place).norm();
        };
        const auto nearest = std::min_element(seen.blocks.begin(), seen.blocks.end(), nearer);
        rows.push_back(static_cast<int>(nearest - seen.blocks.begin()));
    }
    return rows;
}

/// Forces of the contacts between each pair of blocks, as they add up: which corner carries them is the pair's affair.
std::map<std::pair<int, int>, Eigen::Vector2d> contactForces(const Frame& frame) {
    std::map<std::pair<int, int>, Eigen::Vector2d> sums;
    for (const ContactFrame& c : frame.contacts) {
        const auto pair = std::minmax(c.blockA, c.blockB);
        auto& sum = sums.try_emplace({pair.first, pair.second}, Eigen::Vector2d::Zero()).first->second;
        sum += Eigen::Vector2d(c.normalForce, std::abs(c.shearForce));
    }
    return sums;
}

struct Comparison {
    double largest = 0.0, difference = 0.0;
    std::string where;

    void add(double own, double seen, const std::string& name) {
        largest = std::max(largest, std::abs(own));
        if (std::abs(own - seen) <= difference) return;
        difference = std::abs(own - seen);
        where = name;
    }
    std::string broken(double relative, double least) const {
        if (difference <= relative * std::max(largest, least)) return {};
        std::ostringstream text;
        text << where << " differs by " << difference << ", the largest being " << largest << "; ";
        return text.str();
    }
};

void compareBolts(const Frame& own, const Frame& seen, double side, const std::string& when, Comparison& forces) {
    for (std::size_t b = 0; b < own.bolts.size(); ++b)
        for (std::size_t n = 0; n < own.bolts[b].nodes.size(); ++n) {
            const BoltNodeFrame& x = own.bolts[b].nodes[n];
            const BoltNodeFrame& y = seen.bolts[b].nodes[n];
            const std::string name = when + ", bolt " + std::to_string(b) + ", node " + std::to_string(n);
            forces.add(x.axialForce, y.axialForce, name + ", axial force");
            forces.add(x.anchorForce, y.anchorForce, name + ", anchor force");
            forces.add(x.shearForce, side * y.shearForce, name + ", shear force");
        }
}

void compareContacts(const Frame& own, const Frame& seen, const std::vector<int>& rows, const std::string& when,
                     Comparison& forces) {
    auto theirs = contactForces(seen);
    for (const auto& [pair, force] : contactForces(own)) {
        const auto same = std::minmax(rows[pair.first],
                                      rows[pair.second]);
        const auto found = theirs.find({same.first, same.second});
        const Eigen::Vector2d other = found == theirs.end() ? Eigen::Vector2d::Zero() : found->second;
        const std::string name =
            when + ", blocks " + std::to_string(pair.first) + " and " + std::to_string(pair.second);
        forces.add(force.x(), other.x(), name + ", normal force");
        forces.add(force.y(), other.y(), name + ", shear force");
    }
}

}  // namespace

Eigen::Matrix2d Isometry::matrix() const {
    Eigen::Matrix2d turn;
    turn << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
    if (mirror) turn.col(0) = -turn.col(0);
    return turn;
}

bool canBeTurned(const Scene& scene) {
    return std::none_of(scene.supports.begin(), scene.supports.end(),
                        [](const Support& s) { return s.fix == Fix::X || s.fix == Fix::Y; });
}

Scene seenThrough(const Isometry& isometry, Scene scene) {
    const Eigen::Matrix2d q = isometry.matrix();
    const auto place = [&](Point& p) { p = q * p; };
    place(scene.analysis.gravity);
    for (Block& block : scene.blocks) {
        std::for_each(block.points.begin(), block.points.end(), place);
        block.initialStress = turned(q, block.initialStress);
    }
    for (Support& support : scene.supports) {
        if (support.blockAt) place(*support.blockAt);
        if (support.point) place(*support.point);
    }
    for (Bolt& bolt : scene.bolts) {
        place(bolt.farEnd);
        place(bolt.head);
    }
    for (Stage& stage : scene.stages) changeStage(stage, isometry.mirror, place, place);
    for (Monitor& monitor : scene.monitors) {
        if (monitor.point) place(*monitor.point);
        if (monitor.between) std::for_each(monitor.between->begin(), monitor.between->end(), place);
        place(monitor.axis);
    }
    return scene;
}

std::string differenceThrough(const Isometry& isometry, const Results& own, const Results& seen, double relative) {
    if (own.frames.size() != seen.frames.size()) return "another number of frames";
    if (own.frames.empty()) return "no frames";
    const Eigen::Matrix2d q = isometry.matrix();
    const std::vector<int> rows = rowsThrough(q, own.frames.front(), seen.frames.front());
    Comparison forces, moves;
    for (std::size_t i = 0; i < own.frames.size(); ++i) {
        const Frame& x = own.frames[i];
        const Frame& y = seen.frames[i];
        const std::string when = "frame " + std::to_string(i);
        compareBolts(x, y, isometry.mirror ? -1.0 : 1.0, when, forces);
        compareContacts(x, y, rows, when, forces);
        for (std::size_t b = 0; b < x.blocks.size(); ++b) {
            const Point move = x.blocks[b].displacement;
            const Point other = y.blocks[rows[b]].displacement;
            moves.add(move.norm(), move.norm() + (q * move - other).norm(),
                      when + ", displacement of block " + std::to_string(b));
        }
    }
    return forces.broken(relative, 0.0) + moves.broken(10.0 * relative, 1e-9);  // a tall pile sways with little force
}

}  // namespace keyblock
