// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The marks of bolts in the colours of the window and in pixels, for the canvas,
// its legend and the docks.
#pragma once

#include "ui/figure/mark_theme.h"
#include "ui/picture/marks.h"

#include <QPointF>

class QPainter;

namespace keyblock {

struct Theme;

MarkTheme screenMarks(const Theme& theme);

/// At `at` [px] on a bolt that runs along the unit vector `along`, y downwards; small ones for bolts with many.
void paintMark(QPainter& painter, MarkKind kind, const QPointF& at, const QPointF& along, bool small,
               const MarkTheme& theme);

/// Its name in the legend: "Bonded".
QString markName(MarkKind kind);

}  // namespace keyblock
