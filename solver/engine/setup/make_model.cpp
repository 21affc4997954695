// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/setup/make_model.h"

#include "geometry/polygon.h"
#include "solver/engine/bolt/bolt_model.h"
#include "solver/engine/glue.h"
#include "solver/engine/setup/in_situ.h"
#include "solver/engine/support.h"
#include "solver/scene/lookup.h"
#include "solver/scene/stage_objects.h"
#include "solver/scene/solved_blocks.h"

#include <Eigen/LU>

#include <algorithm>
#include <limits>
#include <cmath>

namespace keyblock {
namespace {

Eigen::Matrix3d elasticityOf(const Material& material, Plane plane) {
    const double e = material.youngsModulus, nu = material.poissonsRatio;
    const double g = e / (2.0 * (1.0 + nu));
    Eigen::Matrix3d c = Eigen::Matrix3d::Zero();
    if (plane == Plane::Stress) {
        c(0, 0) = c(1, 1) = e / (1.0 - nu * nu);
        c(0, 1) = c(1, 0) = nu * c(0, 0);
    } else {
        const double factor = e / ((1.0 + nu) * (1.0 - 2.0 * nu));
        c(0, 0) = c(1, 1) = factor * (1.0 - nu);
        c(0, 1) = c(1, 0) = factor * nu;
    }
    c(2, 2) = g;
    return c;
}

/// Mass matrix ∫ρ TᵀT dA from the exact second moments (theory, "Blocks").
Matrix6 massOf(const Moments& m, double densityTimesThickness) {
    Matrix6 mass = Matrix6::Zero();
    const auto set = [&](int i, int j, double value) { mass(i, j) = mass(j, i) = value * densityTimesThickness; };
    set(0, 0, m.area);
    set(1, 1, m.area);
    set(2, 2, m.sxx + m.syy);
    set(2, 3, -m.sxy);
    set(2, 4, m.sxy);
    set(2, 5, 0.5 * (m.sxx - m.syy));
    set(3, 3, m.sxx);
    set(4, 4, m.syy);
    set(3, 5, 0.5 * m.sxy);
    set(4, 5, 0.5 * m.sxy);
    set(5, 5, 0.25 * (m.sxx + m.syy));
    return mass;
}

std::vector<Point> relative(const std::vector<Point>& points, const Point& origin) {
    std::vector<Point> moved;
    moved.reserve(points.size());
    for (const Point& p : points) moved.push_back(p - origin);
    return moved;
}

Material plateMaterial(const Plate& plate) { return {plate.density, plate.youngsModulus, plate.poissonsRatio}; }

/// Corners at which the outline turns by more than round-off, a glued edge meets one that is not glued, or the joint
/// changes.
std::vector<int> turnsOf(const BlockModel& block) {
    constexpr double straight = 1e-9;  // sine of the turning angle
    const std::vector<Point>& shape = block.shape;
    const std::vector<char>& inner = block.inner;
    std::vector<int> turns;
    const int n = static_cast<int>(shape.size());
    for (int i = 0; i < n; ++i) {
        const Point in = shape[i] - shape[(i + n - 1) % n], out = shape[(i + 1) % n] - shape[i];
        const bool bends = std::abs(cross(in, out)) > straight * in.norm() * out.norm();
        const int before = (i + n - 1) % n;
        const std::vector<int>& openings = block.faceOpenings;
        const bool differs = jointOfFace(block, i) != jointOfFace(block, before) ||
                             (!openings.empty() && openings[i] != openings[before]);
        if (bends || differs || (!inner.empty() && inner[i] != inner[before])) turns.push_back(i);
    }
    return turns;
}

/// Row of Model::joints for a joint index of the scene.
int jointRow(const Scene& scene, int joint) {
    const int materials = static_cast<int>(scene.jointMaterials.size());
    return joint == intactJoint ? materials + 1 : joint == builtInJoint ? materials : joint;
}

/// Row of State::openings for a joint or joint set, given by its index in the scene.
int openingRow(const Scene& scene, int source) {
    return source < 0 ? -1 : static_cast<int>(scene.jointMaterials.size()) + 2 + source;
}

/// The last row of State::openings that a stage refers to by the name of a joint; −1 if there is none.
int lastOpening(const Scene& scene) {
    int last = -1;
    for (const Stage& stage : scene.stages)
        for (const Dilation& dilation : stage.dilations) last = std::max(last, dilation.source);
    return openingRow(scene, last);
}

bool letsWavesOut(const Scene& scene) {
    return std::any_of(scene.stages.begin(), scene.stages.end(),
                       [](const Stage& stage) { return !stage.viscousBoundaries.empty(); });
}

/// Sets the data of a cut block's faces that are needed for stages with dilation or viscous boundaries.
void setFaces(const Scene& scene, const std::vector<CutFace>& faces, BlockModel& model) {
    const int last = lastOpening(scene);
    for (const CutFace& face : faces) {
        const int row = openingRow(scene, face.source);
        if (last >= 0) model.faceOpenings.push_back(row <= last ? row : -1);
        if (letsWavesOut(scene)) model.faceSides.push_back(face.side);
    }
}

BlockModel blockModel(const Scene& scene, const Point& origin, const SolvedBlock& solved) {
    const Block& block = scene.blocks[solved.block];
    const bool plate = solved.plateOf >= 0;
    const Material material = plate ? plateMaterial(boltTypeOf(scene, scene.bolts[solved.plateOf]).plate)
                                    : materialOf(scene, block);
    std::vector<Point> corners = counterClockwise(solved.points);
    const Moments m = moments(corners);
    BlockModel model;
    model.name = solved.name;
    model.rock = solved.block;
    model.cell = solved.cell;
    model.plateOf = solved.plateOf;
    model.inner = solved.inner;
    model.shape = relative(corners, m.centroid);
    model.centroid = m.centroid;
    model.area = m.area;
    model.size = std::sqrt(m.area);
    model.mass = material.density * m.area * scene.analysis.thickness;
    model.massMatrix = massOf(m, material.density * scene.analysis.thickness);
    model.elasticity = elasticityOf(material, scene.analysis.plane);
    model.compliance = model.elasticity.inverse();
    model.youngsModulus = material.youngsModulus;
    if (!plate && !block.inOpening) {
        const Stress inSitu = inSituStressAt(scene, m.centroid + origin);
        for (std::size_t i = 0; i < inSitu.size(); ++i) model.initialStress[i] = block.initialStress[i] + inSitu[i];
    }
    model.jointMaterial = jointRow(scene, jointMaterialIndex(scene, block));
    if (!plate && !solved.cell)
        for (const CutFace& face : block.faces) model.faceJoints.push_back(jointRow(scene, face.joint));
    if (!plate && !solved.cell) setFaces(scene, block.faces, model);
    model.turns = turnsOf(model);
    return model;
}

double smallestOf(const Model& model) {
    double smallest = std::numeric_limits<double>::max();
    for (const BlockModel& block : model.blocks) smallest = std::min(smallest, block.size);
    return smallest;
}

double stiffestOf(const Model& model) {
    double stiffest = 0.0;
    for (const BlockModel& block : model.blocks) {
        stiffest = std::max(stiffest, model.numerics.penaltyRatio * block.youngsModulus * model.thickness);
        std::vector<int> joints = block.faceJoints;
        joints.push_back(block.jointMaterial);
        for (int row : joints)
            for (const auto& stiffness : {model.joints[row].normalStiffness, model.joints[row].shearStiffness})
                stiffest = std::max(stiffest, stiffness.value_or(0.0) * block.size * model.thickness);
    }
    for (const BoltModel& bolt : model.bolts)
        for (const BoltElement& element : bolt.elements)
            stiffest = std::max(stiffest,
                                bolt.share * bolt.section.youngsModulus * bolt.section.area / element.length);
    return stiffest;
}

}  // namespace

Model makeModel(const Scene& scene) {
    Model model;
    model.analysis = scene.analysis;
    model.numerics = numericsOf(scene.analysis);
    model.thickness = scene.analysis.thickness;
    model.gravity = scene.analysis.gravity;
    model.size = sceneSize(scene);
    model.tolerance = geometricTolerance(scene);
    const SolvedBlocks solved = solvedBlocks(scene);
    model.origin = solved.origin;
    model.firstOf = solved.firstOf;
    for (const SolvedBlock& block : solved.blocks) model.blocks.push_back(blockModel(scene, model.origin, block));
    for (const SharedEdge& edge : solved.glued) model.glue.push_back(glueModel(scene, model, edge));
    model.joints = jointRows(scene.jointMaterials);
    model.openings = std::max(static_cast<int>(model.joints.size()), lastOpening(scene) + 1);
    model.hasSides = std::any_of(model.blocks.begin(), model.blocks.end(),
                                 [](const BlockModel& block) { return !block.faceSides.empty(); });
    addSupports(scene, model);
    preloadSupports(scene, model);
    for (std::size_t i = 0; i < scene.bolts.size(); ++i) {
        model.bolts.push_back(boltModel(scene, static_cast<int>(i), model));
        model.nodes += static_cast<int>(model.bolts.back().s.size());
    }
    model.stiffest = stiffestOf(model);
    model.smallest = smallestOf(model);
    return model;
}

}  // namespace keyblock
