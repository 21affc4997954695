// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A small numbered flag at a pinned point.
#pragma once

#include <QPointF>
#include <QRectF>

class QPainter;

namespace keyblock {

struct Theme;

/// Rectangle around the flag and its pole [px]. \param foot lower end of the pole [px].
QRectF pinFlagRect(const QPointF& foot, int number);
void paintPinFlag(QPainter& painter, const Theme& theme, const QPointF& foot, int number);

}  // namespace keyblock
