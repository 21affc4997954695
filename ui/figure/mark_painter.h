// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The marks of bolts on paper and on the screen. Shape and colour both show the kind:
// bonded dark, slipping medium, failed pale can also be distinguished in grey.
#pragma once

#include "ui/figure/ink.h"
#include "ui/figure/mark_theme.h"
#include "ui/picture/marks.h"

namespace keyblock {

/// A mark at `at` [mm] on a bolt that runs along the unit vector `along`, y downwards; small ones for bolts with many.
void drawMark(Ink& ink, MarkKind kind, const Point& at, const Point& along, bool small = false,
              const MarkTheme& theme = paperMarks);

/// Its name in the key of a picture.
std::string nameOf(MarkKind kind);

/// An event's number in a circle of `radius` [mm].
void drawNumber(Ink& ink, const Point& at, int number, double radius, const TextStyle& style);

}  // namespace keyblock
