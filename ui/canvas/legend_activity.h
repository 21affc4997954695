// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The key of active, sleeping, fixed and removed blocks in the legend, with their
// numbers.
#pragma once

#include "ui/picture/section/activity.h"

#include <QPointF>

class QPainter;

namespace keyblock {

struct Theme;

double legendActivityHeight();  // [px]
void paintLegendActivity(QPainter& painter, const Theme& theme, const ActivityCounts& counts, const QPointF& at,
                         double width);

}  // namespace keyblock
