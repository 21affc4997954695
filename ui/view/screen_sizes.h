// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sizes of the parts of a section on the screen, in device-independent pixels.
#pragma once

#include "ui/picture/section/detail.h"

namespace keyblock {

inline constexpr double pixelsPerMm = 5.7;  // equivalent of 1 mm on paper
inline constexpr double shankOnScreen = 4.0, casingOfShank = 1.6;  // [px]; width over that of the shank

inline constexpr DetailSizes onTheScreen{.shank = shankOnScreen, .betweenMarks = 10.5, .moved = 6.0,
                                         .scaleForArtificial = 30.0, .spacingForMarks = 10.0,
                                         .spacingForPlates = 15.0, .boltForMarks = 30.0};

/// Width of the bolt shanks [px] at a scale [px per m]: thinner if bolts are crowded, and the same for all bolts.
double shankWidth(const SectionPicture& picture, double scale);

/// Width of the lines between blocks [px]: thinner if the blocks are so small that the lines would hide them.
double lineWidth(const SectionPicture& picture, double scale);

}  // namespace keyblock
