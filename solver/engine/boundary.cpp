// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/boundary.h"

#include "geometry/polygon.h"
#include "solver/engine/model/edge.h"
#include "solver/engine/support.h"
#include "solver/engine/time/mass.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace keyblock {
namespace {

constexpr double touching = 10.0;  // times the geometric tolerance
const double gauss = 0.5 / std::sqrt(3.0);  // distance of a Gauss point from the middle of a face, over the face length

Box boxOfRock(const Model& model) {
    std::vector<Point> corners;
    for (int row = 0; row < model.firstOf.back(); ++row)
        for (const Point& corner : startCorners(model.blocks[row])) corners.push_back(corner);
    return boxOf(corners);
}

using SideList = std::vector<BoundarySide>;

bool isAsked(const SideList& sides, BoundarySide side) {
    return std::any_of(sides.begin(), sides.end(),
                       [&](BoundarySide asked) { return asked == BoundarySide::All || asked == side; });
}

/// The requested sides of the rock. If the cut recorded the sides of block faces, these are used; otherwise the
/// bounding box of the rock decides.
class Boundary {
public:
    Boundary(const Model& model, const SideList& sides)
        : model_(model), sides_(sides), box_(boxOfRock(model)), near_(touching * model.tolerance) {}

    bool holdsFace(int row, int e, const Point& a, const Point& b) const {
        if (!model_.hasSides) return isBetween(a, b);
        const auto& faces = model_.blocks[row].faceSides;
        if (faces.empty()) return false;
        const std::optional<BoundarySide>& side = faces[e];
        return side && isAsked(sides_, *side);
    }

    /// Whether a point of a block lies on these sides. \param place initial position of the point.
    bool holdsPlace(int row, const Point& place) const {
        if (!model_.hasSides) return isBetween(place, place);
        const std::vector<Point> corners = startCorners(model_.blocks[row]);
        for (int e = 0; e < static_cast<int>(corners.size()); ++e) {
            const Edge edge = edgeOf(corners, e);
            const double along = std::clamp(edge.along.dot(place - edge.start), 0.0, edge.length);
            if (!holdsFace(row, e, edge.start, edge.start)) continue;
            if ((edge.start + along * edge.along - place).norm() <= near_) return true;
        }
        return false;
    }

private:
    /// True if both points lie on the same requested side of the box.
    bool isBetween(const Point& a, const Point& b) const {
        const auto low = [&](int axis) { return std::max(a[axis], b[axis]) - box_.min[axis] <= near_; };
        const auto high = [&](int axis) { return box_.max[axis] - std::min(a[axis], b[axis]) <= near_; };
        return (isAsked(sides_, BoundarySide::Left) && low(0)) || (isAsked(sides_, BoundarySide::Right) && high(0)) ||
               (isAsked(sides_, BoundarySide::Bottom) && low(1)) || (isAsked(sides_, BoundarySide::Top) && high(1));
    }

    const Model& model_;
    const SideList& sides_;
    Box box_;
    double near_;
};

void addDashpots(const StepInput& input, StepProblem& problem) {
    if (!problem.moves || input.loads.dashpots.empty()) return;
    const State& state = input.state;
    const SchemeFactors factors = factorsOf(input.options);
    const StepMove move = moveOf(input.options);
    const Eigen::VectorXd motion =
        factors.rate.v * velocitiesOf(input.model, state) + factors.rate.a * accelerationsOf(input.model, state);
    for (const Dashpot& dashpot : input.loads.dashpots) {
        const BlockMotion& block = state.blocks[dashpot.block];
        if (block.absent) continue;
        const auto t = pointMove(input.model, state, dashpot.block, dashpot.place, move).t;
        for (const auto& [axis, damping] : {std::pair(dashpot.across, dashpot.pressure),
                                            std::pair(Point(turnLeft(dashpot.across)), dashpot.shear)}) {
            Link& link = problem.links.emplace_back();
            link.kind = LinkKind::Drag;
            link.a = dashpot.block;
            link.ga = t.transpose() * axis;
            link.law.kind = LawKind::Viscous;
            link.law.stiffness = damping * factors.rate.d;
            const auto first = 6 * static_cast<Eigen::Index>(dashpot.block);
            link.law.offset = -link.ga.dot(motion.segment<6>(first)) / factors.rate.d;
        }
    }
}

}  // namespace

std::vector<Dashpot> dashpotsOn(const Model& model, const State& state, const SideList& sides) {
    std::vector<Dashpot> dashpots;
    const Boundary boundary(model, sides);
    for (int row = 0; row < model.firstOf.back(); ++row) {
        const BlockModel& block = model.blocks[row];
        if (block.fixed || state.blocks[row].absent) continue;
        const std::vector<Point> corners = startCorners(block);
        const double density = block.mass / (block.area * model.thickness);
        const double pressure = std::sqrt(density * block.elasticity(0, 0));  // density times wave speed [Pa s/m]
        const double shear = std::sqrt(density * block.elasticity(2, 2));
        for (int e = 0; e < static_cast<int>(corners.size()); ++e) {
            const Edge edge = edgeOf(corners, e);
            if (!boundary.holdsFace(row, e, edge.start, edge.start + edge.length * edge.along)) continue;
            const double area = 0.5 * edge.length * model.thickness;
            for (double share : {0.5 - gauss, 0.5 + gauss})
                dashpots.push_back({row, edge.start + share * edge.length * edge.along - block.centroid, edge.outward,
                                    area * pressure, area * shear});
        }
    }
    return dashpots;
}

std::vector<std::size_t> supportsOn(const Model& model, const State& state, const SideList& sides) {
    std::vector<std::size_t> supports;
    const Boundary boundary(model, sides);
    for (std::size_t h = 0; h < model.supports.size(); ++h) {
        const PointSupport& support = model.supports[h];
        if (state.blocks[support.block].absent) continue;
        if (boundary.holdsPlace(support.block, startOf(model, support))) supports.push_back(h);
    }
    return supports;
}

const Carrier boundaryCarrier{.name = "dashpots", .addLinks = addDashpots};

}  // namespace keyblock
