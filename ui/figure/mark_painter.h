// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Draws the marks of bolts on paper and on screen. Shape and colour both show the kind
// of mark: dark for bonded, medium for slipping and pale for failed nodes, which also
// differ in greyscale.
#pragma once

#include "ui/figure/ink.h"
#include "ui/figure/mark_theme.h"
#include "ui/picture/section/marks.h"

namespace keyblock {

/// Draws a mark at `at` [mm] on a bolt with the direction `along` (unit vector, y downwards). \param small true: use
/// the smaller size, for bolts with many marks.
void drawMark(Ink& ink, MarkKind kind, const Point& at, const Point& along, bool small = false,
              const MarkTheme& theme = paperMarks);

/// The name that the key of a figure uses for a kind of mark.
std::string nameOf(MarkKind kind);

/// Draws the number of an event in a circle of the given radius [mm].
void drawNumber(Ink& ink, const Point& at, int number, double radius, const TextStyle& style);

}  // namespace keyblock
