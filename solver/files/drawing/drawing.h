// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is read from a drawing (DXF) or a list (CSV) before anything is made of it:
// lines on layers, each with the place in the file that it comes from, and
// everything that could not be imported, with the reason.
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

/// Where something is in the file.
struct DrawingPlace {
    int line = 0;  // from 1
    std::string handle;  // the DXF handle; empty: none
};

struct DrawnCircle {
    Point center{0.0, 0.0};
    double radius = 0.0;
};

/// A line of points, in the units of the drawing.
struct DrawnLine {
    std::string layer;
    std::string kind;  // `ARC`; of a block, `ARC in block 'bolt'`
    DrawingPlace place;
    std::vector<Point> points;  // of a closed one the first is not repeated
    bool closed = false;
    std::optional<DrawnCircle> circle;  // that it is
    // of lists; empty: not said
    std::string name;
    std::string material;  // of a joint
    std::string boltType;
    std::optional<double> boltSpacing;  // out of plane [m]
    std::optional<double> pretension;  // [N]
    bool headLast = false;  // a bolt whose head is the last point; else the head has to be found
};

struct NotTaken {
    std::string kind;
    std::string layer;
    DrawingPlace place;
    std::string why;
};

/// An INSERT whose block was put in place.
struct InsertedBlock {
    std::string kind;
    std::string layer;
    std::string block;
};

/// The units that a drawing may have: m, mm, cm, dm, km, um, in, ft, yd, mi, us-ft.
std::span<const std::string_view> lengthUnits();

/// One of `lengthUnits`; null when there is none of that name.
const UnitSymbol* lengthUnitOf(std::string_view word);

/// All of them, with commas between.
std::string lengthUnitWords();

struct Drawing {
    std::vector<DrawnLine> lines;
    std::vector<NotTaken> notTaken;
    std::vector<InsertedBlock> inserted;
    std::vector<std::string> hiddenLayers;  // frozen or off
    const UnitSymbol* unit = nullptr;  // that the file says; null: none
    std::vector<Problem> problems;  // with an error, nothing else is to be used
};

}  // namespace keyblock
