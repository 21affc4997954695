// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Arrows, stress crosses and forces of contacts as lines for the card. They have
// their lengths in pixels, so they are laid anew when the view zooms.
#pragma once

#include "ui/picture/section.h"
#include "ui/view/layer.h"
#include "ui/view/view_colours.h"

namespace keyblock {

/// Widths of lines are in pixels that do not depend on the display.
struct ForceShapes {
    LayerShapes rims;  // below the lines, round those of contacts that slide
    LayerShapes lines;
};

/// What the picture has of them within a window [m]. \param scale pixels per metre.
ForceShapes forceShapes(const SectionPicture& picture, const Point& origin, double scale, const ViewColours& colours,
                        const Box& window);

}  // namespace keyblock
