// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A section with its legends on a sheet.
#pragma once

#include "ui/figure/figure.h"
#include "ui/picture/section.h"

namespace keyblock {

/// The section for a figure request. \throws CannotDraw for an unknown quantity.
SectionRequest sectionRequestOf(const RunSource& run, const FigureRequest& request);

/// \throws CannotDraw for an unknown quantity.
Figure paintSection(const RunSource& run, const FigureRequest& request);

}  // namespace keyblock
