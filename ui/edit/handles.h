// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Handles with which the user changes the shape of an object: corners, ends, the
// width of a tunnel, the run of a pattern.
#pragma once

#include "ui/edit/edit.h"

#include <string>
#include <vector>

namespace keyblock {

struct Handle {
    Point place{0.0, 0.0};  // [m]
    std::string name;  // shown to the user: `corner 2`, `width`
    std::string pointer;  // of the value that it changes; a corner can be deleted by `removeAt`
    bool isCorner = false;  // of a line with a variable number of corners
};

/// The handles of the object at the pointer; none if it has no shape of its own.
std::vector<Handle> handlesOf(const Scene& scene, const std::string& pointer);

/// Moves handle `index` to the mouse. The width of a tunnel changes symmetrically; moving the crown keeps the floor.
/// The ends of a pattern and the head of a bolt move along the wall if one is near (`reach` [m]).
Edit dragHandle(const Scene& scene, const std::string& pointer, std::size_t index, const Point& place, double reach);

/// Adds a corner to a line or an outline, at its point nearest to `place`. Refused for objects without corners.
Edit withCorner(const Scene& scene, const std::string& pointer, const Point& place);

}  // namespace keyblock
