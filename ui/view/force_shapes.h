// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Arrows, stress crosses and contact forces as lines for the GPU. Their lengths are in
// pixels, so they are rebuilt when the view is zoomed.
#pragma once

#include "ui/picture/section/section.h"
#include "ui/view/layer.h"
#include "ui/view/view_colours.h"

namespace keyblock {

/// Shapes of arrows and contact forces, with line widths in device-independent pixels.
struct ForceShapes {
    LayerShapes rims;  // drawn below the lines, as outlines of those of sliding contacts
    LayerShapes lines;
};

/// Shapes of all arrows in the picture, and of the contact forces within `window` [m].
/// \param origin point to which the corners of the shapes are relative [m]. \param scale device-independent pixels per
/// metre.
ForceShapes forceShapes(const SectionPicture& picture, const Point& origin, double scale, const ViewColours& colours,
                        const Box& window);

}  // namespace keyblock
