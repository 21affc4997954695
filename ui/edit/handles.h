// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Handles that the user drags to change the shape of an object: corners, ends, the
// width of a tunnel, the extent of a bolt pattern.
#pragma once

#include "ui/edit/edit.h"

#include <string>
#include <vector>

namespace keyblock {

struct Handle {
    Point place{0.0, 0.0};  // [m]
    std::string name;  // shown to the user: `corner 2`, `width`
    std::string pointer;  // JSON pointer of the value that it changes; a corner can be deleted with `removeAt`
    bool isCorner = false;  // belongs to a line with any number of corners
};

/// The handles of the object at a JSON pointer; empty if it has no shape of its own.
std::vector<Handle> handlesOf(const Scene& scene, const std::string& pointer);

/// Moves the handle with this index to `place`, the position of the mouse [m]. The width of a tunnel changes
/// symmetrically; moving the crown keeps the floor in place. The ends of a pattern and the head of a bolt snap to the
/// wall; for a bolt, the wall must be within `reach` [m].
Edit dragHandle(const Scene& scene, const std::string& pointer, std::size_t index, const Point& place, double reach);

/// Adds a corner to a line or an outline, at the point of the line nearest to `place`. Refused for objects without
/// corners.
Edit withCorner(const Scene& scene, const std::string& pointer, const Point& place);

}  // namespace keyblock
