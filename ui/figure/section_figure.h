// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A section with its legends on a sheet.
#pragma once

#include "ui/figure/figure.h"
#include "ui/picture/section.h"

namespace keyblock {

/// What a request for a figure asks of a section. \throws CannotDraw for a quantity that there is not.
SectionRequest sectionRequestOf(const RunSource& run, const FigureRequest& request);

/// \throws CannotDraw for a quantity that there is not.
Figure paintSection(const RunSource& run, const FigureRequest& request);

}  // namespace keyblock
