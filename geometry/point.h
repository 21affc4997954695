// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The only point and vector type of the program: two doubles, with the operations
// of Eigen.
#pragma once

#include <Eigen/Core>

namespace keyblock {

using Point = Eigen::Vector2d;  // [m]

/// The z component of the cross product a × b.
inline double cross(const Point& a, const Point& b) { return a.x() * b.y() - a.y() * b.x(); }

/// The vector `a` rotated by 90° counter-clockwise.
inline Point turnLeft(const Point& a) { return {-a.y(), a.x()}; }

}  // namespace keyblock
