// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One quantity in the legend: name and unit, colour bar with ticks and capacities,
// range of the current frame, and sign convention.
#pragma once

#include "ui/picture/section/legend.h"

#include <QPointF>

class QPainter;

namespace keyblock {

struct Theme;

double legendBarHeight(const LegendBar& bar, double width);  // [px]
void paintLegendBar(QPainter& painter, const Theme& theme, const LegendBar& bar, const QPointF& at, double width);

}  // namespace keyblock
