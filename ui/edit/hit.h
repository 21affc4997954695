// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The objects under the mouse, and those selected by a box.
#pragma once

#include "geometry/polygon.h"
#include "ui/edit/scene_objects.h"

#include <span>
#include <vector>

namespace keyblock {

/// Indices of the objects at a point, the most likely target first. Objects with a line or mark within `radius` [m]
/// come first; if several are about equally near, small objects come before large ones. Tunnels and blocks that merely
/// contain the point come last. A domain or a region is hit only on its outline. Joints are not hit inside openings.
std::vector<std::size_t> objectsAt(std::span<const SceneObject> objects, const Point& place, double radius);

enum class BoxRule {
    Encloses,  // the box must contain the whole object
    Crosses  // the box must contain a part of the object
};

/// Indices of the objects that the box selects according to `rule`, in ascending order.
std::vector<std::size_t> objectsIn(std::span<const SceneObject> objects, const Box& box, BoxRule rule);

}  // namespace keyblock
