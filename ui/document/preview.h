// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The drawing shown on the canvas while the user edits: blocks after cutting, openings,
// and bolts with their bonded nodes.
#pragma once

#include "ui/picture/section/section.h"

namespace keyblock {

/// The drawing of a scene, regardless of its stages; empty if it has no blocks.
/// \param solved the scene after `cutScene`
/// \pre the scene has been checked and has no errors.
SectionPicture drawingPicture(const Scene& solved);

}  // namespace keyblock
