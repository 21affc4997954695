// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The key of marks in the legend, in two columns: only the kinds given, nodes of bolts
// first, then steel and face plates.
#pragma once

#include "ui/picture/section/marks.h"

#include <QPointF>

#include <vector>

class QPainter;

namespace keyblock {

struct Theme;

double legendKeyHeight(const std::vector<MarkKind>& kinds, bool highlighted);  // [px]; 0: no key
void paintLegendKey(QPainter& painter, const Theme& theme, const std::vector<MarkKind>& kinds, bool highlighted,
                    const QPointF& at);

}  // namespace keyblock
