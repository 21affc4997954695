// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/verify/scenes.h"

#include <cmath>
#include <numbers>

namespace keyblock {

namespace {

constexpr double axisHeight = 0.5;  // [m] height of the bolt axis
constexpr double paperBond = 84.78e6;  // [N/m] per node
constexpr double paperResidual = 2.24e3;  // [N] per node

double jointOf(const Scene& scene) { return scene.blocks.back().points.front().x(); }

Point inRightBlock(const Scene& scene) {
    return 0.5 * (scene.blocks.back().points[0] + scene.blocks.back().points[1]) + Point(0.0, 0.1);
}

}  // namespace

Scene emptyScene(double youngsModulus, double poissonsRatio, double frictionAngle) {
    Scene scene;
    scene.analysis.plane = Plane::Stress;
    scene.analysis.tolerance = 1e-10;
    scene.materials = {{"rock", {2700.0, youngsModulus, poissonsRatio}}};
    JointMaterial joint;
    joint.frictionAngle = frictionAngle;
    scene.jointMaterials = {{"joint", joint}};
    return scene;
}

Block boxBlock(const std::string& name, const Point& low, const Point& high) {
    Block block;
    block.name = name;
    block.points = {low, {high.x(), low.y()}, high, {low.x(), high.y()}};
    block.material = "rock";
    block.jointMaterial = "joint";
    return block;
}

Scene inclineScene(double slope, double frictionAngle, double duration) {
    Scene scene = emptyScene(60e9, 0.25, frictionAngle);
    scene.analysis.gravity = {0.0, -gravity};
    const double c = std::cos(slope * std::numbers::pi / 180.0), s = std::sin(slope * std::numbers::pi / 180.0);
    const auto turned = [&](const Point& p) { return Point(c * p.x() + s * p.y(), -s * p.x() + c * p.y()); };
    Block base = boxBlock("slope", {0, -1}, {12, 0}), slider = boxBlock("slider", {1, 0}, {2, 0.5});
    for (Block* block : {&base, &slider})
        for (Point& p : block->points) p = turned(p);
    scene.blocks = {base, slider};
    Support support;
    support.blockAt = turned({6, -0.5});
    scene.supports = {support};
    Monitor monitor;
    monitor.name = "slider";
    monitor.point = turned({1.5, 0.25});
    scene.monitors = {monitor};
    Stage stage;
    stage.name = "run";
    stage.kind = StageKind::Dynamic;
    stage.duration = duration;
    stage.timeStep = 1e-3;
    scene.stages = {stage};
    return scene;
}

Scene twoBlocks(double youngsModulus, double joint, double length) {
    Scene scene = emptyScene(youngsModulus, 0.17, 0.0);
    scene.blocks = {boxBlock("left", {0, 0}, {joint, 1}), boxBlock("right", {joint, 0}, {length, 1})};
    Support support;
    support.blockAt = Point(0.5 * joint, 0.1);
    scene.supports = {support};
    Monitor opening;
    opening.name = "opening";
    opening.between = {Point(joint - 0.001, axisHeight), Point(joint + 0.001, axisHeight)};
    scene.monitors = {opening};
    return scene;
}

Stage pullStage(const Scene& scene, double displacement, int increments) {
    Stage stage;
    stage.name = "pull";
    stage.increments = increments;
    Motion motion;
    motion.blockAt = inRightBlock(scene);
    motion.table = {{0.0, 0.0}, {1.0, displacement}};
    stage.motions = {motion};
    return stage;
}

Stage loadStage(const Scene& scene, double force, int increments) {
    Stage stage;
    stage.name = "load";
    stage.increments = increments;
    Load load;
    load.blockAt = inRightBlock(scene);
    load.force = {force, 0.0};
    load.table = {{0.0, 0.0}, {1.0, 1.0}};
    stage.loads = {load};
    return stage;
}

void addBolt(Scene& scene, const BoltType& type, double from, double to, int divisions, PlateKind plate) {
    scene.boltTypes = {type};
    Bolt bolt;
    bolt.name = "B";
    bolt.type = type.name;
    bolt.farEnd = {from, axisHeight};
    bolt.head = {to, axisHeight};
    bolt.divisions = divisions;
    bolt.plate = plate;
    scene.bolts = {bolt};
    Monitor force;
    force.name = "joint force";
    force.bolt = "B";
    force.at = jointOf(scene) - from - 1e-4;
    scene.monitors.push_back(force);
}

BoltType linearType(double area, double youngsModulus) {
    BoltType type;
    type.name = "bar";
    type.area = area;
    type.diameter = std::sqrt(4.0 * area / std::numbers::pi);
    type.youngsModulus = youngsModulus;
    type.normalStiffness = 5e9;
    type.plate.normalStiffness = 1e9;
    return type;
}

BoltType steelType(double area, const Table& steel) {
    BoltType type = linearType(area, 0.0);
    type.youngsModulus.reset();
    type.steel = steel;
    return type;
}

Anchor anchorRange(Per per, AnchorLaw law, double stiffness, std::optional<double> strength, double residual) {
    Anchor anchor;
    anchor.per = per;
    anchor.law = law;
    anchor.stiffness = stiffness;
    anchor.strength = strength;
    anchor.residual = residual;
    return anchor;
}

Anchor anchorAt(double s, AnchorLaw law, double stiffness) {
    Anchor anchor = anchorRange(Per::Node, law, stiffness, std::nullopt, 0.0);
    anchor.at = BoltPlace{false, s};
    return anchor;
}

double barArea() { return std::numbers::pi * 0.01 * 0.01; }

Scene paperRebar(double youngsModulus, double peak, int divisions, double rockModulus, double displacement,
                 int increments) {
    Scene scene = twoBlocks(rockModulus, 1.0, 2.0);
    BoltType type = linearType(barArea(), youngsModulus);
    Anchor bond = anchorRange(Per::Node, AnchorLaw::PeakResidual, paperBond, peak, paperResidual);
    bond.restick = false;
    type.anchors = {bond};
    const double inset = divisions == 59 ? 1.0 / 60.0 : 0.0;
    addBolt(scene, type, inset, 2.0 - inset, divisions, PlateKind::None);
    scene.stages = {pullStage(scene, displacement, increments)};
    return scene;
}

Scene paperDBolt(const Table& steel, PlateKind plate, double rockModulus, double displacement, int increments) {
    Scene scene = twoBlocks(rockModulus, 1.0, 2.0);
    BoltType type = steelType(barArea(), steel);
    type.boltClass = BoltClass::DMC;
    for (const double s : {0.10, 0.43, 1.23, 1.80}) type.anchors.push_back(anchorAt(s, AnchorLaw::Elastic, paperBond));
    addBolt(scene, type, 0.0, 2.0, 60, plate);
    scene.stages = {pullStage(scene, displacement, increments)};
    return scene;
}

Scene elasticRebar(double springStiffness, double rockModulus) {
    Scene scene = twoBlocks(rockModulus, 1.0, 2.0);
    BoltType type = linearType(barArea(), 212.08e9);
    type.anchors = {anchorRange(Per::Node, AnchorLaw::Elastic, springStiffness, std::nullopt, 0.0)};
    addBolt(scene, type, 0.0, 2.0, 60, PlateKind::Spring);
    Monitor force = scene.monitors.back();
    force.name = "force at 0.683 m";
    force.at = 20.5 / 30.0;
    scene.monitors.push_back(force);
    scene.stages = {loadStage(scene, 200e3, 4)};
    return scene;
}

}  // namespace keyblock
