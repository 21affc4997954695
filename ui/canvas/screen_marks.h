// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Draws the marks of bolts in pixels and in the colours of the window, for the canvas,
// its legend and the docks.
#pragma once

#include "ui/figure/mark_theme.h"
#include "ui/picture/section/marks.h"

#include <QPointF>

class QPainter;

namespace keyblock {

struct Theme;

MarkTheme screenMarks(const Theme& theme);

/// Draws a mark at `at` [px] on a bolt with the direction `along` (unit vector, y downwards).
/// \param small true: use the smaller size, for bolts with many marks.
void paintMark(QPainter& painter, MarkKind kind, const QPointF& at, const QPointF& along, bool small,
               const MarkTheme& theme);

/// The name that the legend uses for a kind of mark, such as "Bonded".
QString markName(MarkKind kind);

}  // namespace keyblock
