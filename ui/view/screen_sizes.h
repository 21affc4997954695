// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sizes of a section on the screen, in pixels that do not depend on the display.
#pragma once

#include "ui/picture/detail.h"

namespace keyblock {

inline constexpr double pixelsPerMm = 5.7;  // of paper: what is as large on both
inline constexpr double shankOnScreen = 4.0, casingOfShank = 1.6;  // [px]; over the shank

inline constexpr DetailSizes onTheScreen{.shank = shankOnScreen, .betweenMarks = 10.5, .moved = 6.0,
                                         .scaleForArtificial = 30.0, .spacingForMarks = 10.0,
                                         .spacingForPlates = 15.0, .boltForMarks = 30.0};

/// Width of the shanks at `scale` [px per m]: less where bolts are crowded, and all alike [px].
double shankWidth(const SectionPicture& picture, double scale);

/// Width of the lines between blocks: fainter where blocks are so small that lines would hide them [px].
double lineWidth(const SectionPicture& picture, double scale);

}  // namespace keyblock
