// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// On which side of a line a point lies, decided without round-off: whether an
// outline is sound must not hang on the last digit.
#pragma once

#include "geometry/point.h"

namespace keyblock {

/// 1 where a→b→c turns left, −1 where it turns right, 0 where the three lie on a line; exact for all coordinates
/// whose products neither overflow nor fall below 1e-290.
int orientation(const Point& a, const Point& b, const Point& c);

/// True when two closed segments share a point, exactly; segments without length count as points.
bool segmentsMeet(const Point& a, const Point& b, const Point& c, const Point& d);

}  // namespace keyblock
