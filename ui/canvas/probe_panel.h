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

/// Paints the panel next to the mouse pointer, inside the canvas.
/// \param mouse position of the pointer [px]. \param size size of the canvas [px].
void paintProbePanel(QPainter& painter, const Theme& theme, const ProbeReading& reading, const QPointF& mouse,
                     const QSizeF& size);

}  // namespace keyblock
