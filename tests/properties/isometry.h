// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A scene seen turned, or in a mirror: the laws know no direction, so its result
// must be the turned or mirrored one.
#pragma once

#include "solver/results/results.h"
#include "solver/scene/scene.h"

#include <Eigen/Core>

#include <string>

namespace keyblock {

/// First mirrored at x = 0, then turned about (0, 0).
struct Isometry {
    bool mirror = false;
    double angle = 0.0;  // [rad] counter-clockwise

    Eigen::Matrix2d matrix() const;
};

/// True where the scene says nothing that holds for the axes x and y only, such as a point held in x alone.
bool canBeTurned(const Scene& scene);

/// The scene as the isometry shows it: every place, direction, stress and spin.
Scene seenThrough(const Isometry& isometry, Scene scene);

/// Largest difference of any force of a bolt or contact over the largest force of the run, taken over all frames, and
/// of any displacement over the largest. \return what differs by more than `relative`, ten times that for displacements;
/// empty where nothing does.
std::string differenceThrough(const Isometry& isometry, const Results& own, const Results& seen, double relative);

}  // namespace keyblock
