// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
#include "solver/verify/extremes/conditions.h"

#include <Eigen/Geometry>

#include <numbers>
#include <utility>

namespace keyblock {

namespace {

Eigen::Matrix2d placingMatrix(const Conditions& conditions) {
    Eigen::Matrix2d matrix = Eigen::Matrix2d::Identity();
    if (conditions.turn != 0.0)
        matrix = Eigen::Rotation2Dd(conditions.turn * std::numbers::pi / 180.0).toRotationMatrix();
    if (conditions.mirrored) matrix.col(0) = -matrix.col(0);
    return matrix;
}

/// Applies `place` to every point of a scene and `direct` to every direction.
template <typename Place, typename Direct>
void transform(Scene& scene, Place place, Direct direct, double handedness) {
    direct(scene.analysis.gravity);
    for (Block& block : scene.blocks)
        for (Point& p : block.points) place(p);
    if (scene.domain)
        for (Point& p : scene.domain->boundary) place(p);
    for (SceneJoint& joint : scene.joints)
        for (Point& p : joint.points) place(p);
    for (SceneTunnel& tunnel : scene.tunnels) {
        place(tunnel.center);
        for (Point& p : tunnel.points) place(p);
    }
    for (Support& support : scene.supports) {
        if (support.blockAt) place(*support.blockAt);
        if (support.point) place(*support.point);
    }
    for (Bolt& bolt : scene.bolts) {
        place(bolt.farEnd);
        place(bolt.head);
    }
    for (Monitor& monitor : scene.monitors) {
        if (monitor.point) place(*monitor.point);
        if (monitor.between)
            for (Point& p : *monitor.between) place(p);
        direct(monitor.axis);
    }
    for (Stage& stage : scene.stages) {
        for (Motion& motion : stage.motions) {
            place(motion.blockAt);
            direct(motion.axis);
        }
        for (Load& load : stage.loads) {
            if (load.blockAt) place(*load.blockAt);
            if (load.at) place(*load.at);
            if (load.point) place(*load.point);
            if (load.along)
                for (Point& p : *load.along) place(p);
            direct(load.force);
        }
        for (InitialVelocity& initial : stage.initialVelocities) {
            place(initial.blockAt);
            direct(initial.velocity);
            initial.spin *= handedness;
        }
    }
}

}  // namespace

Scene placed(const Conditions& conditions, Scene scene) {
    const Eigen::Matrix2d matrix = placingMatrix(conditions);
    const Point offset(conditions.offset, conditions.offset);
    const auto place = [&](Point& p) { p = matrix * p + offset; };
    const auto direct = [&](Point& p) { p = matrix * p; };
    transform(scene, place, direct, conditions.mirrored ? -1.0 : 1.0);
    return scene;
}

Point inOwnAxes(const Conditions& conditions, const Point& vector) {
    return placingMatrix(conditions).transpose() * vector;
}

}  // namespace keyblock
