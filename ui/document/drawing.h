// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the canvas shows while a person draws: blocks as they are cut, openings,
// bolts with their anchored points.
#pragma once

#include "ui/picture/section.h"

namespace keyblock {

/// The picture of a scene before anything happened to it; empty of one without blocks.
/// \param solved what `cutScene` makes of the scene. \pre the scene was checked without errors.
SectionPicture drawingPicture(const Scene& solved);

}  // namespace keyblock
