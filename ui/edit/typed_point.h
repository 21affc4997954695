// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads points as typed by the user while drawing: absolute, relative to the last
// point, polar, or as a distance in the direction of the mouse.
#pragma once

#include "geometry/point.h"

#include <optional>
#include <string>
#include <string_view>

namespace keyblock {

/// Reference points for typed relative coordinates.
struct TypingContext {
    std::optional<Point> previous;  // the last point drawn [m]
    Point mouse{0.0, 0.0};  // position of the mouse [m], after snapping and the ortho constraint
};

/// A point, or a message that says what is wrong with the text and what to enter.
struct TypedPoint {
    std::optional<Point> place;  // [m]; within the allowed distance from the origin
    std::string problem;  // a sentence; empty if there is a point
};

/// Reads `12.5,3` (absolute), `@2,0` (relative to the last point), `@3<45` (length and direction in degrees from the
/// last point) or `2.5` (distance from the last point towards the mouse). Each number may have a unit or be an
/// expression. With decimal commas, a semicolon separates the coordinates: `12,5;3,25`.
/// \param unit unit of lengths typed without a unit.
TypedPoint typedPoint(std::string_view text, const TypingContext& context, std::string_view unit = "m");

}  // namespace keyblock
