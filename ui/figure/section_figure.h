// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Figure with a section and its legends.
#pragma once

#include "ui/figure/figure.h"
#include "ui/picture/section/section.h"

namespace keyblock {

/// Converts a figure request to a section request. \throws CannotDraw if the quantity is unknown.
SectionRequest sectionRequestOf(const RunSource& run, const FigureRequest& request);

/// Draws the section. \throws CannotDraw if the quantity is unknown.
Figure paintSection(const RunSource& run, const FigureRequest& request);

}  // namespace keyblock
