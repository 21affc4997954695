// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the probe tells, on a panel beside the mouse.
#pragma once

#include <QPointF>
#include <QSizeF>

class QPainter;

namespace keyblock {

struct ProbeReading;
struct Theme;

/// Beside `mouse`, where there is room on a canvas of that size [px].
void paintProbePanel(QPainter& painter, const Theme& theme, const ProbeReading& reading, const QPointF& mouse,
                     const QSizeF& size);

}  // namespace keyblock
