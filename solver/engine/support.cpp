// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/support.h"

#include "solver/scene/lookup.h"

#include <cassert>
#include <map>
#include <utility>

namespace keyblock {
namespace {

/// Corners on the boundary of the domain, by block and corner, and whether x and y are fixed there.
using BoundaryCorners = std::map<std::pair<int, int>, std::pair<bool, bool>>;

/// Fixes the blocks with a face on a side of the domain: whole blocks, or only the ends of the face.
void fixBoundary(const Scene& scene, const Support& support, Model& model, BoundaryCorners& fixedCorners) {
    for (std::size_t b = 0; b < scene.blocks.size(); ++b) {
        const std::vector<CutFace>& faces = scene.blocks[b].faces;
        const int row = model.firstOf[b], corners = static_cast<int>(faces.size());
        for (int e = 0; e < corners; ++e) {
            if (!isOnSide(faces[e], *support.boundary)) continue;
            if (support.fix == Fix::All) model.blocks[row].fixed = true;
            for (int corner : {e, (e + 1) % corners})
                if (support.fix != Fix::All) {
                    auto& [x, y] = fixedCorners[{row, corner}];
                    x = x || support.fix != Fix::Y;
                    y = y || support.fix != Fix::X;
                }
        }
    }
}

void addSupportLinks(const StepInput& input, StepProblem& problem) {
    addSupportLinks(input.model, input.state, moveOf(input.options), problem);
}

void addSupportEnergy(const Model& model, const State& state, StoredEnergy& energy) {
    StepProblem links = stepForLinks(model);
    addSupportLinks(model, state, {}, links);
    energy.strain = addLinkEnergy(links, energy.strain);
}

}  // namespace

void addSupports(const Scene& scene, Model& model) {
    assert(model.firstOf.size() == scene.blocks.size() + 1);
    BoundaryCorners corners;
    for (const Support& support : scene.supports) {
        if (support.boundary) {
            fixBoundary(scene, support, model, corners);
            continue;
        }
        if (support.blockAt) {
            const std::size_t block = blockAt(scene, *support.blockAt);
            for (int row = model.firstOf[block]; row < model.firstOf[block + 1]; ++row) model.blocks[row].fixed = true;
            continue;
        }
        const int block = rowHolding(model, blockWithPoint(scene, *support.point), *support.point - model.origin);
        const BlockModel& body = model.blocks[block];
        const double stiffness = model.numerics.penaltyRatio * body.youngsModulus * model.thickness;
        model.supports.push_back({block, *support.point - model.origin - body.centroid, support.fix != Fix::Y,
                              support.fix != Fix::X, stiffness});
    }
    for (const auto& [corner, axes] : corners) {
        const BlockModel& body = model.blocks[corner.first];
        const double stiffness = model.numerics.penaltyRatio * body.youngsModulus * model.thickness;
        model.supports.push_back({corner.first, body.shape[corner.second], axes.first,
                              axes.second, stiffness});
    }
}

void addSupportLinks(const Model& model, const State& state, const StepMove& move, StepProblem& problem) {
    for (std::size_t h = 0; h < model.supports.size(); ++h) {
        const PointSupport& point = model.supports[h];
        const BlockMotion& block = state.blocks[point.block];
        if (block.absent || (!state.supports.empty() && state.supports[h].quiet)) continue;
        const Point moved = materialPoint(block, point.place) - startOf(model, point);
        const PointMove over = pointMove(model, state, point.block, point.place, move);
        for (int axis : {0, 1}) {
            if (!(axis == 0 ? point.x : point.y)) continue;
            Link& link = problem.links.emplace_back();
            link.kind = LinkKind::Support;
            link.a = point.block;
            link.owner = static_cast<int>(h);
            link.part = axis;
            link.ga = over.t.row(axis).transpose();
            link.strain = moved[axis];
            link.shift = over.beyond[axis];
            link.law.stiffness = point.stiffness;
            link.law.offset = point.preload[axis] / point.stiffness;
            if (!state.supports.empty()) link.law.offset += state.supports[h].offset[axis];
        }
    }
}

Point startOf(const Model& model, const PointSupport& support) {
    return model.blocks[support.block].centroid + support.place;
}

double supportStrain(const Model& model, const BlockMotion& block, const Link& link) {
    const PointSupport& point = model.supports[link.owner];
    return (materialPoint(block, point.place) - startOf(model, point))[link.part];
}

WallForce releaseSupport(const Model& model, State& state, std::size_t support) {
    if (state.supports.empty()) state.supports.resize(model.supports.size());
    const PointSupport& point = model.supports[support];
    SupportState& now = state.supports[support];
    const Point start = startOf(model, point);
    const Point moved = materialPoint(state.blocks[point.block], point.place) - start - now.offset;
    const Point all = point.preload - point.stiffness * moved;
    now.quiet = true;
    now.force = {point.x ? all.x() : 0.0, point.y ? all.y() : 0.0};
    WallForce wall;
    wall.block = point.block;
    wall.place = point.place;
    wall.force = now.force;
    wall.ofSupport = true;
    return wall;
}

void restoreSupports(const Model& model, State& state) {
    for (std::size_t h = 0; h < state.supports.size(); ++h) {
        SupportState& now = state.supports[h];
        if (!now.quiet) continue;
        const PointSupport& point = model.supports[h];
        const Point start = startOf(model, point);
        const Point moved = materialPoint(state.blocks[point.block], point.place) - start;
        now.quiet = false;
        now.offset = moved + (now.force - point.preload) / point.stiffness;
    }
}

const Carrier supportCarrier{.name = "point supports", .addLinks = addSupportLinks, .addStoredEnergy = addSupportEnergy};

}  // namespace keyblock
