// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The picture on the canvas while drawing: blocks as they are cut, openings, bolts
// with their anchored points.
#pragma once

#include "ui/picture/section.h"

namespace keyblock {

/// The picture of a scene before any stage; empty if it has no blocks.
/// \param solved result of `cutScene`. \pre the scene was checked without errors.
SectionPicture drawingPicture(const Scene& solved);

}  // namespace keyblock
