// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Exact test of the side of a line on which a point lies, so that the validity of an
// outline does not depend on round-off.
#pragma once

#include "geometry/point.h"

namespace keyblock {

/// 1 if a→b→c turns left, −1 if it turns right, 0 if the points are collinear. Exact unless products of coordinates
/// overflow or are below 1e-290.
int orientation(const Point& a, const Point& b, const Point& c);

/// Exact test whether the closed segments a–b and c–d have a common point. Segments of zero length count as points.
bool segmentsMeet(const Point& a, const Point& b, const Point& c, const Point& d);

}  // namespace keyblock
