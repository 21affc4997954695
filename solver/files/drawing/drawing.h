// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Contents of a drawing (DXF) or list (CSV) before conversion to a scene: lines on
// layers, each with its position in the file, and everything that could not be
// imported, with the reason.
#pragma once

#include "geometry/point.h"
#include "solver/scene/problem.h"
#include "solver/scene/units.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace keyblock {

/// Position of an item in the file.
struct DrawingPlace {
    int line = 0;  // counted from 1
    std::string handle;  // the DXF handle; empty: none
};

struct DrawnCircle {
    Point center{0.0, 0.0};
    double radius = 0.0;
};

/// A polyline, in the units of the drawing.
struct DrawnLine {
    std::string layer;
    std::string kind;  // kind of entity, as in `ARC`, or `ARC in block 'bolt'` for an entity of a block
    DrawingPlace place;
    std::vector<Point> points;  // if the line is closed, the first point is not repeated
    bool closed = false;
    std::optional<DrawnCircle> circle;  // the circle, if the line is one
    // set by lists only; empty: not given
    std::string name;
    std::string material;  // joint material
    std::string boltType;
    std::optional<double> boltSpacing;  // out-of-plane spacing [m]
    std::optional<double> pretension;  // [N]
    bool headLast = false;  // true: a bolt whose head is the last point; false: the head has to be found
};

struct NotTaken {
    std::string kind;
    std::string layer;
    DrawingPlace place;
    std::string why;
};

/// An INSERT entity whose block contents were added to the drawing.
struct InsertedBlock {
    std::string kind;
    std::string layer;
    std::string block;
};

/// Names of the length units supported in drawings: m, mm, cm, dm, km, um, in, ft, yd, mi, us-ft.
std::span<const std::string_view> lengthUnits();

/// The unit with this name; null if it is not one of `lengthUnits`.
const UnitSymbol* lengthUnitOf(std::string_view word);

/// Comma-separated list of `lengthUnits`, for messages.
std::string lengthUnitWords();

struct Drawing {
    std::vector<DrawnLine> lines;
    std::vector<NotTaken> notTaken;
    std::vector<InsertedBlock> inserted;
    std::vector<std::string> hiddenLayers;  // layers that are frozen or off
    const UnitSymbol* unit = nullptr;  // unit given in the file; null: none
    std::vector<Problem> problems;  // if any is an error, the other members must not be used
};

}  // namespace keyblock
