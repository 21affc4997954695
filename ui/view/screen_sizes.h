// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sizes of a section on the screen in device-independent pixels.
#pragma once

#include "ui/picture/detail.h"

namespace keyblock {

inline constexpr double pixelsPerMm = 5.7;  // of paper: objects of the same size on both
inline constexpr double shankOnScreen = 4.0, casingOfShank = 1.6;  // [px]; over the shank

inline constexpr DetailSizes onTheScreen{.shank = shankOnScreen, .betweenMarks = 10.5, .moved = 6.0,
                                         .scaleForArtificial = 30.0, .spacingForMarks = 10.0,
                                         .spacingForPlates = 15.0, .boltForMarks = 30.0};

/// Width of the shanks at `scale` [px per m]: thinner if bolts are crowded, the same for all [px].
double shankWidth(const SectionPicture& picture, double scale);

/// Width of the lines between blocks: thinner if blocks are so small that lines would hide them [px].
double lineWidth(const SectionPicture& picture, double scale);

}  // namespace keyblock
