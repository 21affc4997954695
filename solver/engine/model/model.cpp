// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/model/model.h"

#include "geometry/polygon.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

namespace keyblock {

std::vector<Point> startCorners(const BlockModel& block) {
    std::vector<Point> corners = block.shape;
    for (Point& p : corners) p += block.centroid;
    return corners;
}

bool sameRock(const Model& model, int a, int b) {
    if (a == b) return true;
    const auto &first = model.blocks[a], &second = model.blocks[b];
    return first.cell && second.cell && first.rock == second.rock;
}

int wholeOf(const Model& model, int row) {
    return model.blocks[row].cell ? model.firstOf[model.blocks[row].rock] : row;
}

int endOfWhole(const Model& model, int first) {
    return model.blocks[first].cell ? model.firstOf[model.blocks[first].rock + 1] : first + 1;
}

double wholeArea(const Model& model, int first) {
    assert(first == wholeOf(model, first));
    double area = 0.0;
    for (int row = first; row < endOfWhole(model, first); ++row) area += model.blocks[row].area;
    return area;
}

double wholeSize(const Model& model, int first) { return std::sqrt(wholeArea(model, first)); }

int rowHolding(const Model& model, int block, const Point& place) {
    const int first = model.firstOf[block], end = model.firstOf[block + 1];
    int beside = first;
    for (int row = end - 1; row >= first && end - first > 1; --row) {
        const Side side = locate(startCorners(model.blocks[row]), place, model.tolerance);
        if (side == Side::Inside) return row;
        if (side == Side::Boundary) beside = row;
    }
    return beside;
}

JointModel jointModel(const JointMaterial& material) {
    const auto tangent = [](double angle) { return std::tan(angle * std::numbers::pi / 180.0); };
    JointModel joint;
    joint.tanPhi = tangent(material.frictionAngle);
    joint.cohesion = material.cohesion;
    joint.tensileStrength = material.tensileStrength;
    const double residual = material.residualFrictionAngle.value_or(material.frictionAngle);
    joint.tanResidual = std::min(joint.tanPhi, tangent(residual));
    joint.normalStiffness = material.normalStiffness;
    joint.shearStiffness = material.shearStiffness;
    joint.crushingStrength = material.crushingStrength;
    return joint;
}

std::vector<JointModel> jointRows(const std::vector<std::pair<std::string, JointMaterial>>& materials) {
    std::vector<JointModel> rows;
    for (const auto& [name, material] : materials) rows.push_back(jointModel(material));
    rows.push_back(jointModel(builtInJointMaterial));
    JointModel& intact = rows.emplace_back(jointModel(builtInJointMaterial));
    intact.cohesion = intact.tensileStrength = std::numeric_limits<double>::infinity();
    return rows;
}

}  // namespace keyblock
