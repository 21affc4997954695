// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "wall.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace keyblock {

namespace {

Block brick(double left, double bottom, double width, double height) {
    Block block;
    block.points = {{left, bottom}, {left + width, bottom}, {left + width, bottom + height}, {left, bottom + height}};
    block.material = "stone";
    block.jointMaterial = "joint";
    return block;
}

/// Calls `change` with every point that says where a block, a support, a motion, a bolt or a monitor is.
template <class Change>
void forEachPlace(Scene& scene, Change change) {
    for (Block& block : scene.blocks)
        for (Point& p : block.points) change(p);
    for (Support& support : scene.supports)
        if (support.blockAt) change(*support.blockAt);
    for (Bolt& bolt : scene.bolts) {
        change(bolt.farEnd);
        change(bolt.head);
    }
    for (Stage& stage : scene.stages)
        for (Motion& motion : stage.motions) change(motion.blockAt);
    for (Monitor& monitor : scene.monitors)
        if (monitor.between)
            for (Point& p : *monitor.between) change(p);
}

}  // namespace

Scene brickWall(const WallSetting& setting) {
    Scene scene;
    scene.analysis.tolerance = 1e-10;
    scene.analysis.gravity = setting.gravity;
    scene.materials = {{"stone", {2500.0, 10e9, 0.25}}};
    JointMaterial joint;
    joint.frictionAngle = setting.frictionAngle;
    scene.jointMaterials = {{"joint", joint}};
    scene.blocks = {brick(-1.0, -1.0, setting.columns + 2.5, 1.0)};
    for (int row = 0; row < setting.rows; ++row) {
        const bool shifted = row % 2 == 1;
        if (shifted) scene.blocks.push_back(brick(0.0, 0.5 * row, 0.5, 0.5));
        for (int column = 0; column < setting.columns - shifted; ++column)
            scene.blocks.push_back(brick(column + 0.5 * shifted, 0.5 * row, 1.0, 0.5));
        if (shifted) scene.blocks.push_back(brick(setting.columns - 0.5, 0.5 * row, 0.5, 0.5));
    }
    Support base;
    base.blockAt = Point(0.5, -0.5);
    scene.supports = {base};

    Stage stage;
    stage.name = "wall";
    stage.kind = StageKind::Dynamic;
    stage.duration = setting.duration;
    stage.timeStep = setting.timeStep;
    scene.stages = {stage};
    scene.output.frames = 1;
    return scene;
}

Scene settledWall(int columns, int rows, double duration) {
    Scene scene = brickWall({.columns = columns, .rows = rows, .duration = duration});
    scene.analysis.tolerance = 1e-4;
    scene.analysis.penaltyRatio = 40.0;
    scene.materials[0].second.poissonsRatio = 0.2;
    Stage settle;
    settle.name = "settle";
    scene.stages.insert(scene.stages.begin(), settle);
    return scene;
}

Scene tiltedWall(int columns, int rows, double duration) {
    Scene scene = settledWall(columns, rows, duration);
    Stage& tilted = scene.stages.back();
    StrengthChange& weaker = tilted.set.emplace_back();
    weaker.jointMaterial = "joint";
    weaker.frictionAngle = 20.0;
    Acceleration along;
    along.record = {{0.0, 1.0}, {1.0, 1.0}};
    along.factor = 9.81 * std::sin(25.0 * std::numbers::pi / 180.0);
    tilted.bodyAcceleration = along;
    return scene;
}

Scene moved(Scene scene, const Point& by) {
    forEachPlace(scene, [&](Point& p) { p += by; });
    return scene;
}

Scene mirrored(Scene scene) {
    forEachPlace(scene, [](Point& p) { p.x() = -p.x(); });
    scene.analysis.gravity.x() = -scene.analysis.gravity.x();
    for (Stage& stage : scene.stages)
        for (Motion& motion : stage.motions) motion.axis.x() = -motion.axis.x();
    return scene;
}

}  // namespace keyblock
