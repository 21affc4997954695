// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Arrows, stress crosses and contact forces as lines for the GPU. Their lengths are
// in pixels, so they are rebuilt when the view zooms.
#pragma once

#include "ui/picture/section.h"
#include "ui/view/layer.h"
#include "ui/view/view_colours.h"

namespace keyblock {

/// Line widths in device-independent pixels.
struct ForceShapes {
    LayerShapes rims;  // below the lines, around those of sliding contacts
    LayerShapes lines;
};

/// Those of the picture within a window [m]. \param scale pixels per metre.
ForceShapes forceShapes(const SectionPicture& picture, const Point& origin, double scale, const ViewColours& colours,
                        const Box& window);

}  // namespace keyblock
