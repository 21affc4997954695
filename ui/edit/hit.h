// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What lies under the mouse, and what a box drawn with it chooses.
#pragma once

#include "geometry/polygon.h"
#include "ui/edit/scene_objects.h"

#include <span>
#include <vector>

namespace keyblock {

/// Indices of objects within `radius` [m] of a place, the likeliest meant first: small things before large ones that lie
/// about as near, insides of openings and blocks last. A domain or a region is met on its outline only, joints not in openings.
std::vector<std::size_t> objectsAt(std::span<const SceneObject> objects, const Point& place, double radius);

enum class BoxRule {
    Encloses,  // all of the object lies in the box
    Crosses  // some of it does
};

/// Indices of the objects that the box chooses, in their order.
std::vector<std::size_t> objectsIn(std::span<const SceneObject> objects, const Box& box, BoxRule rule);

}  // namespace keyblock
