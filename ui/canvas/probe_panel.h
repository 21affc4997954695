// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A panel next to the mouse with the values read by the probe.
#pragma once

#include <QPointF>
#include <QSizeF>

class QPainter;

namespace keyblock {

struct ProbeReading;
struct Theme;

/// Paints the panel next to `mouse`, inside a canvas of the given size [px].
void paintProbePanel(QPainter& painter, const Theme& theme, const ProbeReading& reading, const QPointF& mouse,
                     const QSizeF& size);

}  // namespace keyblock
