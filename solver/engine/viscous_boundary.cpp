// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/viscous_boundary.h"

#include "geometry/polygon.h"
#include "solver/engine/contacts.h"
#include "solver/engine/step_build.h"

#include <cmath>

namespace keyblock {
namespace {

constexpr double touching = 10.0;  // times the geometric tolerance
const double gauss = 0.5 / std::sqrt(3.0);  // of a face's length from its middle: two such points are exact

Box boxOfRock(const Model& model) {
    std::vector<Point> corners;
    for (int row = 0; row < model.firstOf.back(); ++row)
        for (const Point& corner : startCorners(model.blocks[row])) corners.push_back(corner);
    return boxOf(corners);
}

/// Which sides a place at the start lies on, of those asked for.
Sides sidesAt(const Model& model, const Box& box, const Sides& asked, const Point& place) {
    const double near = touching * model.tolerance;
    Sides at;
    at.left = asked.left && place.x() - box.min.x() <= near;
    at.right = asked.right && box.max.x() - place.x() <= near;
    at.bottom = asked.bottom && place.y() - box.min.y() <= near;
    at.top = asked.top && box.max.y() - place.y() <= near;
    return at;
}

}  // namespace

std::vector<Dashpot> dashpotsOn(const Model& model, const State& state, const Sides& sides) {
    std::vector<Dashpot> dashpots;
    const Box box = boxOfRock(model);
    for (int row = 0; row < model.firstOf.back(); ++row) {
        const BlockModel& block = model.blocks[row];
        if (block.fixed || state.blocks[row].absent) continue;
        const std::vector<Point> corners = startCorners(block);
        const double density = block.mass / (block.area * model.thickness);
        const double pressure = std::sqrt(density * block.elasticity(0, 0));  // density times wave speed [Pa s/m]
        const double shear = std::sqrt(density * block.elasticity(2, 2));
        for (int e = 0; e < static_cast<int>(corners.size()); ++e) {
            const Edge edge = edgeOf(corners, e);
            const Point end = edge.start + edge.length * edge.along;
            const Sides a = sidesAt(model, box, sides, edge.start), b = sidesAt(model, box, sides, end);
            const bool upright = (a.left && b.left) || (a.right && b.right);
            if (!upright && !(a.bottom && b.bottom) && !(a.top && b.top)) continue;
            const double area = 0.5 * edge.length * model.thickness;
            const Point damping = upright ? Point(pressure, shear) : Point(shear, pressure);
            for (double share : {0.5 - gauss, 0.5 + gauss})
                dashpots.push_back({row, edge.start + share * edge.length * edge.along - block.centroid, area * damping});
        }
    }
    return dashpots;
}

std::vector<WallForce> letGo(const Model& model, State& state, const Sides& sides) {
    std::vector<WallForce> forces;
    const Box box = boxOfRock(model);
    const double before = bookedEnergy(model, state);
    for (std::size_t h = 0; h < model.held.size(); ++h) {
        const HeldPoint& held = model.held[h];
        const Point start = model.blocks[held.block].centroid + held.place;
        if (state.blocks[held.block].absent || !sidesAt(model, box, sides, start).any()) continue;
        if (state.held.empty()) state.held.resize(model.held.size());
        HeldState& now = state.held[h];
        const Point moved = materialPoint(state.blocks[held.block], held.place) - start - now.offset;
        const Point all = held.preload - held.stiffness * moved;
        now.quiet = true;
        now.force = {held.x ? all.x() : 0.0, held.y ? all.y() : 0.0};
        WallForce wall;
        wall.block = held.block;
        wall.place = held.place;
        wall.force = now.force;
        forces.push_back(wall);
    }
    state.energy.released += before - bookedEnergy(model, state);
    return forces;
}

void holdAgain(const Model& model, State& state) {
    if (state.held.empty()) return;
    const double before = bookedEnergy(model, state);
    for (std::size_t h = 0; h < model.held.size(); ++h) {
        HeldState& now = state.held[h];
        if (!now.quiet) continue;
        const HeldPoint& held = model.held[h];
        const Point start = model.blocks[held.block].centroid + held.place;
        const Point moved = materialPoint(state.blocks[held.block], held.place) - start;
        now.quiet = false;
        now.offset = moved + (now.force - held.preload) / held.stiffness;
    }
    state.energy.external += bookedEnergy(model, state) - before;  // the springs are strained from outside
}

void addDashpots(const Model& model, const State& state, const Loads& loads, const StepOptions& options,
                 StepProblem& problem) {
    const SchemeFactors factors = factorsOf(options);
    const Eigen::VectorXd motion =
        factors.rate.v * velocitiesOf(model, state) + factors.rate.a * accelerationsOf(model, state);
    for (const Dashpot& dashpot : loads.dashpots) {
        const BlockMotion& block = state.blocks[dashpot.block];
        if (block.absent) continue;
        const auto t = displacementMatrix(block, materialPoint(block, dashpot.place));
        for (int axis : {0, 1}) {
            Link& link = problem.links.emplace_back();
            link.kind = LinkKind::Drag;
            link.a = dashpot.block;
            link.ga = t.row(axis).transpose();
            link.law.kind = LawKind::Viscous;
            link.law.stiffness = dashpot.damping[axis] * factors.rate.d;
            link.law.offset = -link.ga.dot(motion.segment<6>(6 * static_cast<Eigen::Index>(dashpot.block))) / factors.rate.d;
        }
    }
}

}  // namespace keyblock
