// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Places as a person types them while drawing: absolute, relative to the last
// point, polar, or so far in the direction of the mouse.
#pragma once

#include "geometry/point.h"

#include <optional>
#include <string>
#include <string_view>

namespace keyblock {

/// What is known when a place is typed.
struct TypingContext {
    std::optional<Point> previous;  // the last point of what is drawn [m]
    Point mouse{0.0, 0.0};  // where the mouse (with snap and ortho) is [m]
};

/// A place, or what is wrong with the text and what to type.
struct TypedPoint {
    std::optional<Point> place;  // [m], usable
    std::string problem;  // a sentence; empty when there is a place
};

/// Reads `12.5,3` (absolute), `@2,0` (from the last point), `@3<45` (length and degrees from the last point) or `2.5`
/// (that far from the last point towards the mouse). Each number may have a unit or be a sum; `unit` is that of bare
/// lengths. `12,5;3,25` separates by a semicolon where commas are decimals.
TypedPoint typedPoint(std::string_view text, const TypingContext& context, std::string_view unit = "m");

}  // namespace keyblock
