// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One quantity of the legend: name and unit, bar of colours with ticks and
// capacities, what the values are now, and what a positive one means.
#pragma once

#include "ui/picture/legend.h"

#include <QPointF>

class QPainter;

namespace keyblock {

struct Theme;

double legendBarHeight(const LegendBar& bar, double width);  // [px]
void paintLegendBar(QPainter& painter, const Theme& theme, const LegendBar& bar, const QPointF& at, double width);

}  // namespace keyblock
