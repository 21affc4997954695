// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Points by which a person takes hold of one object and changes its shape: corners,
// ends, the width of a tunnel, the run of a pattern.
#pragma once

#include "ui/edit/edit.h"

#include <string>
#include <vector>

namespace keyblock {

struct Handle {
    Point place{0.0, 0.0};  // [m]
    std::string name;  // for people: `corner 2`, `width`
    std::string pointer;  // of the value that it changes; a corner's can be taken out by `removeAt`
    bool isCorner = false;  // of a line that could have more or fewer of them
};

/// The handles of the object that the pointer leads to; none of what has no shape of its own.
std::vector<Handle> handlesOf(const Scene& scene, const std::string& pointer);

/// Puts handle `index` where the mouse is. A tunnel stays in the middle of its width; its floor stays where the crown is
/// taken. The ends of a pattern and the head of a bolt go along the wall where one is near (`reach` [m]).
Edit dragHandle(const Scene& scene, const std::string& pointer, std::size_t index, const Point& place, double reach);

/// A new corner in a line or an outline, at the place of it nearest to `place`. Refused for objects without corners.
Edit withCorner(const Scene& scene, const std::string& pointer, const Point& place);

}  // namespace keyblock
