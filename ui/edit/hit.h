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

/// Indices of objects within `radius` [m] of a point, the most likely target first: small objects before large ones
/// at a similar distance, interiors of openings and blocks last. A domain or a region is hit on its outline only, joints
/// not inside openings.
std::vector<std::size_t> objectsAt(std::span<const SceneObject> objects, const Point& place, double radius);

enum class BoxRule {
    Encloses,  // the whole object is in the box
    Crosses  // part of it is in the box
};

/// Indices of the objects selected by the box, in their order.
std::vector<std::size_t> objectsIn(std::span<const SceneObject> objects, const Box& box, BoxRule rule);

}  // namespace keyblock
