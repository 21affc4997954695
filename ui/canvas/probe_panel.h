// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The values of the probe on a panel next to the mouse.
#pragma once

#include <QPointF>
#include <QSizeF>

class QPainter;

namespace keyblock {

struct ProbeReading;
struct Theme;

/// Next to `mouse`, within a canvas of that size [px].
void paintProbePanel(QPainter& painter, const Theme& theme, const ProbeReading& reading, const QPointF& mouse,
                     const QSizeF& size);

}  // namespace keyblock
