// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The scale bar at the lower left of the canvas.
#pragma once

#include <QRectF>

class QPainter;

namespace keyblock {

class CanvasMap;
struct Theme;

/// Rectangle of the panel around the scale bar [px].
QRectF scaleBarRect(const CanvasMap& map);
void paintScaleBar(QPainter& painter, const Theme& theme, const CanvasMap& map);

}  // namespace keyblock
