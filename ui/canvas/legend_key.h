// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The key of marks in the legend: only kinds that the scene has, in two columns,
// points of bolts first, then steel and plates.
#pragma once

#include "ui/picture/marks.h"

#include <QPointF>

#include <vector>

class QPainter;

namespace keyblock {

struct Theme;

double legendKeyHeight(const std::vector<MarkKind>& kinds, bool highlighted);  // [px]; 0: nothing to explain
void paintLegendKey(QPainter& painter, const Theme& theme, const std::vector<MarkKind>& kinds, bool highlighted,
                    const QPointF& at);

}  // namespace keyblock
