// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// From the document to masses, stiffnesses, slots and meshes.
#include "solver/engine/model/model.h"

#include "geometry/polygon.h"
#include "solver/engine/bolt/slots.h"
#include "solver/engine/glue.h"
#include "solver/engine/setup/in_situ.h"
#include "solver/scene/lookup.h"
#include "solver/scene/presence.h"
#include "solver/scene/solved_blocks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

namespace keyblock {
namespace {

/// Normal spring of the shank per metre where a type gives none: a 20 mm bar grouted
/// into a 33 mm hole, 2·E_g/(D/d − 1) with E_g 8.8 GPa (theory, "The dowel") [N/m²].
constexpr double groutNormalStiffness = 27.08e9;
constexpr double coarseDivisions = 60.0;

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

/// ∫ρ TᵀT dA from the exact second moments (theory, "Blocks").
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

/// Corners at which an outline turns by more than round-off, its edges cease to be glued, or their joint material
/// changes.
std::vector<int> turnsOf(const BlockModel& block) {
    constexpr double straight = 1e-9;  // sine of the angle
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

/// Row of Model::joints of an index of the scene.
int jointRow(const Scene& scene, int joint) {
    const int materials = static_cast<int>(scene.jointMaterials.size());
    return joint == intactJoint ? materials + 1 : joint == builtInJoint ? materials : joint;
}

/// Row of State::openings of a joint or set by its place in the scene.
int openingRow(const Scene& scene, int source) {
    return source < 0 ? -1 : static_cast<int>(scene.jointMaterials.size()) + 2 + source;
}

/// The last row of State::openings that a stage asks for by the name of a joint; −1: none does.
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

/// What stages that dilate joints or let waves out need of the faces of a cut block.
void setFaces(const Scene& scene, const std::vector<CutFace>& faces, BlockModel& model) {
    const int last = lastOpening(scene);
    for (const CutFace& face : faces) {
        const int row = openingRow(scene, face.source);
        if (last >= 0) model.faceOpenings.push_back(row <= last ? row : -1);
        if (letsWavesOut(scene)) model.faceSides.push_back(face.side);
    }
}

BlockModel blockModel(const Scene& scene, const Point& origin, const SolvedBlock& solved) {
    const Block& block = scene.blocks[static_cast<std::size_t>(solved.block)];
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
    model.youngsModulus = material.youngsModulus;
    if (!plate) {
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

/// Corners of blocks on the domain's boundary, by block and corner, and whether x and y are held there.
using BoundaryCorners = std::map<std::pair<int, int>, std::pair<bool, bool>>;

/// Holds what has a face on a side of the domain: whole blocks, or the ends of the face.
void holdBoundary(const Scene& scene, const Support& support, Model& model, BoundaryCorners& held) {
    for (std::size_t b = 0; b < scene.blocks.size(); ++b) {
        const std::vector<CutFace>& faces = scene.blocks[b].faces;
        const int row = model.firstOf[b], corners = static_cast<int>(faces.size());
        for (int e = 0; e < corners; ++e) {
            if (!isOnSide(faces[static_cast<std::size_t>(e)], *support.boundary)) continue;
            if (support.fix == Fix::All) model.blocks[row].fixed = true;
            for (int corner : {e, (e + 1) % corners})
                if (support.fix != Fix::All) {
                    auto& [x, y] = held[{row, corner}];
                    x = x || support.fix != Fix::Y;
                    y = y || support.fix != Fix::X;
                }
        }
    }
}

void holdSupports(const Scene& scene, Model& model) {
    BoundaryCorners corners;
    for (const Support& support : scene.supports) {
        if (support.boundary) {
            holdBoundary(scene, support, model, corners);
            continue;
        }
        if (support.blockAt) {
            const auto block = static_cast<std::size_t>(blockAt(scene, *support.blockAt));
            for (int row = model.firstOf[block]; row < model.firstOf[block + 1]; ++row) model.blocks[row].fixed = true;
            continue;
        }
        const int block = rowHolding(model, blockWithPoint(scene, *support.point), *support.point - model.origin);
        const BlockModel& held = model.blocks[static_cast<std::size_t>(block)];
        const double stiffness = scene.analysis.penaltyRatio * held.youngsModulus * model.thickness;
        model.held.push_back({block, *support.point - model.origin - held.centroid, support.fix != Fix::Y,
                              support.fix != Fix::X, stiffness});
    }
    for (const auto& [corner, axes] : corners) {
        const BlockModel& held = model.blocks[static_cast<std::size_t>(corner.first)];
        const double stiffness = scene.analysis.penaltyRatio * held.youngsModulus * model.thickness;
        model.held.push_back({corner.first, held.shape[static_cast<std::size_t>(corner.second)], axes.first,
                              axes.second, stiffness});
    }
}

BeamSection sectionOf(const BoltType& type) {
    const double d = type.diameter;
    const double full = std::numbers::pi * d * d / 4.0;
    BeamSection section;
    section.area = type.area.value_or(full);
    const double inner2 = std::max(0.0, d * d - 4.0 * section.area / std::numbers::pi);
    section.secondMoment = type.secondMoment.value_or(std::numbers::pi / 64.0 * (d * d * d * d - inner2 * inner2));
    section.youngsModulus = type.steel.empty() ? type.youngsModulus.value_or(200e9)
                                               : Backbone::of(type.steel).modulus;
    section.shearModulus = type.shearModulus;
    section.shearCoefficient = type.shearCoefficient;
    section.density = type.density;
    return section;
}

/// N_p = A × the tensile strength [N]; 0 for steel without limit.
double tensileStrengthOf(const BoltType& type, double area) {
    double stress = 0.0;
    for (const auto& [strain, value] : type.steel) stress = std::max(stress, value);
    return type.steel.empty() ? 0.0 : type.tensileStrength.value_or(stress) * area;
}

/// Of a tube (d³ − d_i³)/6, d_i² = d² − 4A/π; of a full bar d³/6 [m³].
double plasticModulusOf(const BoltType& type, double area) {
    const double d = type.diameter, inner = std::sqrt(std::max(0.0, d * d - 4.0 * area / std::numbers::pi));
    return type.plasticModulus.value_or((d * d * d - inner * inner * inner) / 6.0);
}

void setSteel(const BoltType& type, BoltModel& bolt) {
    bolt.diameter = type.diameter;
    bolt.dynamicFactor = type.dynamicFactor;
    bolt.bends = type.bending != Bending::None;
    bolt.plasticModulus = plasticModulusOf(type, bolt.section.area);
    bolt.tensileStrength = tensileStrengthOf(type, bolt.section.area);
    bolt.shearStrength = type.shearStrengthRatio * bolt.tensileStrength;
    if (type.steel.empty()) return;
    bolt.steel = Backbone::of(type.steel);
    if (type.dynamicFactor != 1.0) bolt.dynamicSteel = bolt.steel->strengthened(type.dynamicFactor);
    bolt.hinges = type.bending == Bending::ElasticPlastic;
    bolt.interacts = type.ruptureRule == RuptureRule::Interaction;
}

double placeOf(const BoltPlace& place, double length) { return place.head ? length : place.s; }

AnchorModel anchorModel(const Anchor& anchor, double dynamicFactor) {
    AnchorModel model;
    model.real = true;
    model.law = anchor.law;
    model.per = anchor.at ? Per::Node : anchor.per;
    model.stiffness = anchor.stiffness;
    model.strength = anchor.strength;
    model.residual = anchor.law == AnchorLaw::Frictional ? anchor.strength.value_or(0.0) : anchor.residual;
    model.tanPhi = std::tan(anchor.frictionAngle * std::numbers::pi / 180.0);
    model.restick = anchor.restick;
    model.boltLost = anchor.onFailure == OnFailure::BoltLost;
    model.curveEnds = anchor.law == AnchorLaw::Curve && anchor.after == AfterCurve::Zero;
    if (anchor.law == AnchorLaw::Curve) model.curve = Backbone::of(anchor.curve);
    if (model.curve && dynamicFactor != 1.0) model.dynamicCurve = model.curve->strengthened(dynamicFactor);
    return model;
}

int nearestNode(const std::vector<double>& nodes, double s) {
    int best = 0;
    for (int i = 1; i < static_cast<int>(nodes.size()); ++i)
        if (std::abs(nodes[i] - s) < std::abs(nodes[best] - s) * (1.0 - 1e-12)) best = i;
    return best;
}

/// What is left of a stretch once another is taken out of it.
std::vector<Stretch> without(const std::vector<Stretch>& stretches, const Stretch& taken) {
    std::vector<Stretch> left;
    for (const auto& [from, to] : stretches) {
        if (std::min(to, taken.first) > from) left.emplace_back(from, std::min(to, taken.first));
        if (to > std::max(from, taken.second)) left.emplace_back(std::max(from, taken.second), to);
    }
    return left;
}

/// Stretches of the bolt that each entry holds: later entries take theirs from earlier ones.
std::vector<std::vector<Stretch>> stretchesOf(const std::vector<Anchor>& entries, double length) {
    std::vector<std::vector<Stretch>> stretches;
    for (const Anchor& entry : entries) {
        const Stretch own{placeOf(entry.from, length), placeOf(entry.to, length)};
        if (!entry.at)
            for (std::vector<Stretch>& earlier : stretches) earlier = without(earlier, own);
        stretches.push_back({own});
    }
    return stretches;
}

/// Later entries override earlier ones on the nodes they share.
std::vector<AnchorModel> anchorsOfNodes(const std::vector<Anchor>& entries, const std::vector<double>& nodes,
                                        double length, double tolerance, double dynamicFactor) {
    std::vector<AnchorModel> anchors(nodes.size());
    for (std::size_t e = 0; e < entries.size(); ++e) {
        const Anchor& entry = entries[e];
        AnchorModel model = anchorModel(entry, dynamicFactor);
        model.entry = static_cast<int>(e);
        const double from = placeOf(entry.from, length), to = placeOf(entry.to, length);
        bool any = false;
        for (std::size_t i = 0; i < nodes.size() && !entry.at; ++i) {
            if (nodes[i] < from - tolerance || nodes[i] > to + tolerance) continue;
            anchors[i] = model;
            any = true;
        }
        const double middle = entry.at ? placeOf(*entry.at, length) : 0.5 * (from + to);
        if (!any) anchors[static_cast<std::size_t>(nearestNode(nodes, middle))] = model;
    }
    return anchors;
}

void setSprings(const Plate& type, PlateModel& plate) {
    plate.present = true;
    plate.normalStiffness = type.normalStiffness;
    plate.shearStiffness = type.shearStiffness;
    plate.normalStrength = type.normalStrength;
    plate.shearStrength = type.shearStrength;
}

/// Ties the head to its place on the plate that is a block, square to the face that it lies against.
PlateModel blockPlate(const Model& model, const BoltModel& bolt, int index, const BoltType& type) {
    PlateModel plate;
    for (plate.block = model.firstOf.back(); model.blocks[plate.block].plateOf != index;) ++plate.block;
    const BlockModel& body = model.blocks[plate.block];
    plate.place = bolt.farEnd + bolt.s.back() * bolt.axis - body.centroid;
    plate.along = turnLeft((body.shape[1] - body.shape[0]).normalized());
    setSprings(type.plate, plate);
    return plate;
}

PlateModel plateModel(const Model& model, const BoltModel& bolt, const BoltType& type) {
    PlateModel plate;
    const double length = bolt.s.back();
    const double reach = bolt.elements.back().length + model.tolerance;
    double nearest = std::numeric_limits<double>::max();
    for (const Slot& slot : bolt.slots) {
        const double away = std::max(0.0, length - slot.s3);
        if (away > reach || away >= nearest) continue;
        nearest = away;
        plate.block = slot.block;
    }
    if (plate.block < 0) return plate;
    plate.place = bolt.farEnd + length * bolt.axis - model.blocks[static_cast<std::size_t>(plate.block)].centroid;
    plate.along = bolt.axis;
    setSprings(type.plate, plate);
    return plate;
}

void setNormalSprings(BoltModel& bolt, const BoltType& type, bool automatic) {
    bolt.normalStiffness = type.normalStiffness.value_or(groutNormalStiffness);
    bolt.normalPer = type.normalStiffness ? type.normalPer : Per::Length;
    if (automatic && bolt.normalPer == Per::Node) {
        bolt.normalStiffness *= coarseDivisions / bolt.s.back();
        bolt.normalPer = Per::Length;
    }
}

/// Length over which a dowel in these springs bends: 1/β, β = (K/4EI)^¼ [m].
double dowelLengthOf(const BoltType& type, const BeamSection& section, double length) {
    double k = type.normalStiffness.value_or(groutNormalStiffness);
    if (type.normalStiffness && type.normalPer == Per::Node) k *= coarseDivisions / length;
    return std::pow(4.0 * section.youngsModulus * section.secondMoment / k, 0.25);
}

BoltModel boltModel(const Scene& scene, int index, const Model& model) {
    const Bolt& bolt = scene.bolts[static_cast<std::size_t>(index)];
    const BoltType& type = boltTypeOf(scene, bolt);
    BoltModel b;
    b.name = bolt.name;
    b.farEnd = bolt.farEnd - model.origin;
    const Point head = bolt.head - model.origin;
    const double length = (head - b.farEnd).norm();
    b.axis = (head - b.farEnd) / length;
    b.angle = std::atan2(b.axis.y(), b.axis.x());
    b.share = model.thickness / bolt.spacingOutOfPlane.value_or(model.thickness);
    b.section = sectionOf(type);
    setSteel(type, b);
    b.pretension = bolt.pretension;
    b.slots = slotsAlong(model, b.farEnd, head);
    b.joints = jointPlaces(model, b.slots, length);
    b.dowelLength = dowelLengthOf(type, b.section, length);
    b.s = boltNodes(length, bolt.divisions, b.joints, b.dowelLength);
    for (std::size_t i = 0; i + 1 < b.s.size(); ++i) {
        const bool shears = std::any_of(b.joints.begin(), b.joints.end(), [&](double s) {
            return s >= b.s[i] - model.tolerance && s <= b.s[i + 1] + model.tolerance;
        });
        b.elements.push_back({b.s[i + 1] - b.s[i], shears});
    }
    for (double s : b.s) b.startBlock.push_back(startBlockOf(model, b.slots, s));
    b.anchors = anchorsOfNodes(anchorsOf(scene, bolt), b.s, length, model.tolerance, type.dynamicFactor);
    b.stretches = stretchesOf(anchorsOf(scene, bolt), length);
    setNormalSprings(b, type, !bolt.divisions);
    if (bolt.plate == PlateKind::Spring) b.plate = plateModel(model, b, type);
    if (bolt.plate == PlateKind::Block) b.plate = blockPlate(model, b, index, type);
    b.firstNode = model.nodes;
    return b;
}

double stiffestOf(const Model& model) {
    double stiffest = 0.0;
    for (const BlockModel& block : model.blocks) {
        stiffest = std::max(stiffest, model.analysis.penaltyRatio * block.youngsModulus * model.thickness);
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

/// Adds nodes up to `to`, in equal elements no longer than `longest`; nothing where `to` is the last node but for
/// round-off.
void fill(std::vector<double>& nodes, double to, double longest) {
    const double from = nodes.back();
    if (to - from <= 1e-9 * longest) return;
    const int count = std::max(1, static_cast<int>(std::ceil((to - from) / longest - 1e-9)));
    for (int i = 1; i <= count; ++i) nodes.push_back(from + (to - from) * i / count);
}

/// Half the element around a joint: no longer than `longest`, clear of the other joints and within the bolt [m].
double halfElement(const std::vector<double>& joints, std::size_t joint, double length, double longest) {
    double room = std::min({longest, 2.0 * joints[joint], 2.0 * (length - joints[joint])});
    if (joint > 0) room = std::min(room, joints[joint] - joints[joint - 1]);
    if (joint + 1 < joints.size()) room = std::min(room, joints[joint + 1] - joints[joint]);
    return 0.5 * room;
}

}  // namespace

std::vector<double> boltNodes(double length, std::optional<int> divisions, const std::vector<double>& joints,
                              double dowel) {
    std::vector<double> nodes{0.0};
    if (divisions) {
        fill(nodes, length, length / *divisions * (1.0 + 1e-9));
        return nodes;
    }
    const double coarse = length / coarseDivisions;
    const double fine = std::min(coarse, dowel / 8.0);
    const double zone = 3.0 * dowel;
    double fineUntil = -1.0;  // how far the zone of the last joint reaches
    for (std::size_t i = 0; i < joints.size(); ++i) {
        const double half = halfElement(joints, i, length, fine);
        const double first = joints[i] - half;
        fill(nodes, std::min(fineUntil, first), fine);
        fill(nodes, std::min(std::max(nodes.back(), joints[i] - zone), first), coarse);
        fill(nodes, first, fine);
        nodes.push_back(joints[i] + half);
        fineUntil = std::min(joints[i] + zone, length);
    }
    fill(nodes, fineUntil, fine);
    fill(nodes, length, coarse);
    nodes.back() = length;
    return nodes;
}

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

Model makeModel(const Scene& scene) {
    Model model;
    model.analysis = scene.analysis;
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
    holdSupports(scene, model);
    preloadHeldPoints(scene, model);
    for (std::size_t i = 0; i < scene.bolts.size(); ++i) {
        model.bolts.push_back(boltModel(scene, static_cast<int>(i), model));
        model.nodes += static_cast<int>(model.bolts.back().s.size());
    }
    model.stiffest = stiffestOf(model);
    return model;
}

}  // namespace keyblock
