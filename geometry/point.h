// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The one point type of the program. Everything in the plane is a pair of
// doubles in metres; Eigen gives the algebra.
#pragma once

#include <Eigen/Core>

namespace keyblock {

using Point = Eigen::Vector2d;  // [m]

/// z component of the cross product a × b.
inline double cross(const Point& a, const Point& b) { return a.x() * b.y() - a.y() * b.x(); }

/// `a` turned by +90°.
inline Point turnLeft(const Point& a) { return {-a.y(), a.x()}; }

}  // namespace keyblock
