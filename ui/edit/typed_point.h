// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Points as typed by the user while drawing: absolute, relative to the last point,
// polar, or a distance in the direction of the mouse.
#pragma once

#include "geometry/point.h"

#include <optional>
#include <string>
#include <string_view>

namespace keyblock {

/// The state when a point is typed.
struct TypingContext {
    std::optional<Point> previous;  // the last point drawn [m]
    Point mouse{0.0, 0.0};  // position of the mouse, with snap and ortho [m]
};

/// A point, or what is wrong with the text and what to type.
struct TypedPoint {
    std::optional<Point> place;  // [m], usable
    std::string problem;  // a sentence; empty if there is a point
};

/// Reads `12.5,3` (absolute), `@2,0` (from the last point), `@3<45` (length and degrees from the last point) or `2.5`
/// (that far from the last point towards the mouse). Each number may have a unit or be an expression; `unit` is that of
/// bare lengths. With decimal commas, a semicolon separates: `12,5;3,25`.
TypedPoint typedPoint(std::string_view text, const TypingContext& context, std::string_view unit = "m");

}  // namespace keyblock
