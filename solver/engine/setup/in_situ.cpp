// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/setup/in_situ.h"

#include "geometry/grid.h"
#include "solver/engine/contact/bonded_face.h"
#include "solver/engine/contact/candidates.h"
#include "solver/engine/contact/springs.h"
#include "solver/engine/glue.h"
#include "solver/engine/model/edge.h"
#include "solver/scene/stage_objects.h"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <utility>

namespace keyblock {
namespace {

constexpr double touching = 10.0;  // times the geometric tolerance
constexpr double parallel = 1e-9;  // sine of the angle between directions that count as parallel

/// Tractions of the in-situ stress on faces, and the forces by which they act at the ends of an interval.
class Tractions {
public:
    Tractions(const Scene& scene, const Model& model) : scene_(scene), model_(model) {}

    /// Traction on a face with the outward normal `outward` [Pa].
    Point at(const Point& place, const Point& outward) const {
        const Stress s = inSituStressAt(scene_, place + model_.origin);
        return {s[0] * outward.x() + s[2] * outward.y(), s[2] * outward.x() + s[1] * outward.y()};
    }

    /// Force at the end `near` of an interval [N]. The forces at both ends together have the resultant, the moment and
    /// the mean strain of the traction, which is linear along the interval.
    Point endForce(const Point& near, const Point& far, const Point& outward) const {
        const double length = (far - near).norm();
        return model_.thickness * length / 6.0 * (2.0 * at(near, outward) + at(far, outward));
    }

    /// True for a plate and for a block in an opening, which carry no in-situ stress.
    bool isApart(int block) const {
        const BlockModel& model = model_.blocks[block];
        return model.plateOf >= 0 || scene_.blocks[model.rock].inOpening;
    }

private:
    const Scene& scene_;
    const Model& model_;
};

int turnAt(const BlockModel& block, int corner) {
    return static_cast<int>(std::lower_bound(block.turns.begin(), block.turns.end(), corner) - block.turns.begin());
}

/// Force on the corner's block from the faces at the corner that lie along the edge [N].
Point cornerForce(const Model& model, const State& state, const Tractions& tractions, const Contact& c) {
    const BlockModel &own = model.blocks[c.blockA], &other = model.blocks[c.blockB];
    const std::vector<Point>& corners = state.blocks[c.blockA].corners;
    const Edge edge = runOf(other, state.blocks[c.blockB].corners, turnAt(other, c.edge));
    const int n = static_cast<int>(own.turns.size()), here = turnAt(own, c.corner);
    const Point& corner = corners[c.corner];
    Point force{0.0, 0.0};
    for (int neighbour : {own.turns[(here + n - 1) % n], own.turns[(here + 1) % n]}) {
        const Point away = corners[neighbour] - corner;
        if (std::abs(edge.outward.dot(away)) > angleSlack * away.norm()) continue;
        const double from = edge.along.dot(corner - edge.start), to = edge.along.dot(corners[neighbour] - edge.start);
        const double a = std::clamp(from, 0.0, edge.length), b = std::clamp(to, 0.0, edge.length);
        if (std::abs(b - a) <= model.tolerance) continue;
        force += tractions.endForce(edge.start + a * edge.along, edge.start + b * edge.along, -edge.outward);
    }
    return force;
}

void preloadContacts(const Model& model, State& state, const Tractions& tractions) {
    for (Contact& c : state.contacts) partBondedFace(model, state.blocks, state.contacts, c);  // forces are per corner
    for (Contact& c : state.contacts) {
        const bool apart = tractions.isApart(c.blockA) || tractions.isApart(c.blockB);
        if (apart || std::abs(c.gap) > touching * model.tolerance) continue;
        const Point force = cornerForce(model, state, tractions, c);
        const Edge edge = edgeOf(state.blocks[c.blockB].corners, c.edge);
        const double normal = edge.outward.dot(force), shear = -edge.along.dot(force);
        if (normal == 0.0 && shear == 0.0) continue;
        if (normal <= 0.0 && !c.bonded) continue;  // an open joint carries no tension
        carryNormal(model, c, gapOf(state.blocks, c), normal);
        carryShear(model, c, slipOf(state.blocks, c), shear);
        c.normalForce = normal;
        c.shearForce = shear;
        c.limit = normal * frictionOf(model, c);
    }
    joinBondedFaces(model, state.blocks, state.contacts);
}

/// Sets the three springs of every edge to carry the traction on it as far as they can. In both cells, the part of the
/// shear that varies along the edge remains unbalanced; it only strains them.
void preloadGlue(const Model& model, State& state, const Tractions& tractions) {
    StepProblem problem = stepForLinks(model);
    addGlueLinks(model, state, problem);
    for (std::size_t first = 0; first + 2 < problem.links.size(); first += 3) {
        const GlueModel& glue = model.glue[problem.links[first].owner];
        if (tractions.isApart(glue.a)) continue;
        const Point middle = model.blocks[glue.a].centroid + glue.placeA, outward = -turnLeft(glue.along);
        const Point from = middle - 0.5 * glue.length * glue.along, to = middle + 0.5 * glue.length * glue.along;
        const BlockMotion& a = state.blocks[glue.a];
        const Vector6 force = displacementMatrix(a, from).transpose() * tractions.endForce(from, to, outward) +
                              displacementMatrix(a, to).transpose() * tractions.endForce(to, from, outward);
        Eigen::Matrix<double, 6, 3> ways;
        for (int part = 0; part < 3; ++part) ways.col(part) = -problem.links[first + part].ga;
        const Eigen::Vector3d carried = ways.colPivHouseholderQr().solve(force);
        for (int part = 0; part < 3; ++part) {
            const Link& link = problem.links[first + part];
            state.glue[link.owner].offset[part] =
                link.strain - carried[part] / link.law.stiffness;
        }
    }
}

/// Boxes of the rock blocks, for finding the blocks near an edge.
BoxGrid rockGrid(const Model& model) {
    std::vector<Box> boxes;
    for (int block = 0; block < model.firstOf.back(); ++block)
        boxes.push_back(boxOf(startCorners(model.blocks[block])));
    return BoxGrid(std::move(boxes));
}

/// Intervals of an edge along which no edge of another block lies, as lengths along the edge [m].
std::vector<std::pair<double, double>> freeStretches(const Model& model, const BoxGrid& rock, int block,
                                                     const Edge& edge) {
    std::vector<std::pair<double, double>> free{{0.0, edge.length}};
    const Point end = edge.start + edge.length * edge.along;
    const Box near = grown({edge.start.cwiseMin(end), edge.start.cwiseMax(end)}, 2.0 * touching * model.tolerance);
    for (int other : rock.meeting(near)) {
        if (other == block) continue;
        const std::vector<Point> corners = startCorners(model.blocks[other]);
        for (int e = 0; e < static_cast<int>(corners.size()); ++e) {
            const Edge face = edgeOf(corners, e);
            const bool along = std::abs(cross(face.along, edge.along)) <= parallel && face.along.dot(edge.along) < 0.0;
            if (!along || std::abs(edge.outward.dot(face.start - edge.start)) > touching * model.tolerance) continue;
            const double high = edge.along.dot(face.start - edge.start), low = high - face.length;
            std::vector<std::pair<double, double>> left;
            for (const auto& [from, to] : free) {
                if (std::min(to, low) - from > model.tolerance) left.emplace_back(from, std::min(to, low));
                if (to - std::max(from, high) > model.tolerance) left.emplace_back(std::max(from, high), to);
            }
            free = std::move(left);
        }
    }
    return free;
}

/// Force on a point of a block from the free faces that end there [N].
Point freeForce(const Model& model, const Tractions& tractions, const BoxGrid& rock, int block, const Point& place) {
    const std::vector<Point> corners = startCorners(model.blocks[block]);
    Point force{0.0, 0.0};
    for (int e = 0; e < static_cast<int>(corners.size()); ++e) {
        const Edge edge = edgeOf(corners, e);
        for (const auto& [from, to] : freeStretches(model, rock, block, edge)) {
            const Point a = edge.start + from * edge.along, b = edge.start + to * edge.along;
            if ((a - place).norm() <= touching * model.tolerance) force += tractions.endForce(a, b, edge.outward);
            if ((b - place).norm() <= touching * model.tolerance) force += tractions.endForce(b, a, edge.outward);
        }
    }
    return force;
}

}  // namespace

void preloadSupports(const Scene& scene, Model& model) {
    if (!scene.inSituStress || model.supports.empty()) return;
    const Tractions tractions(scene, model);
    const BoxGrid rock = rockGrid(model);
    for (PointSupport& support : model.supports) {
        if (tractions.isApart(support.block)) continue;
        const Point place = model.blocks[support.block].centroid + support.place;
        const Point force = freeForce(model, tractions, rock, support.block, place);
        for (int axis : {0, 1}) {
            const auto fixes = [&](const PointSupport& other) {
                const bool same = other.block == support.block;
                return same && (other.place - support.place).norm() <= model.tolerance && (axis == 0 ? other.x : other.y);
            };
            if (!fixes(support)) continue;
            const auto sharing = std::count_if(model.supports.begin(), model.supports.end(), fixes);
            support.preload[axis] = force[axis] / static_cast<double>(sharing);
        }
    }
}

void preloadFaces(const Scene& scene, const Model& model, State& state) {
    if (!scene.inSituStress) return;
    const Tractions tractions(scene, model);
    preloadContacts(model, state, tractions);
    preloadGlue(model, state, tractions);
}

}  // namespace keyblock
