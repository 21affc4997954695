// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One entity of a DXF file as plain values. The numbers of an entity are read by
// libdxflib, which takes what is missing as 0 and believes every count; so each
// entity is checked first, its counts are counted, and it is handed over alone,
// with those of its groups that describe its shape. Headers, tables, texts and all
// other kinds never reach the library.
#pragma once

#include "geometry/curve.h"
#include "solver/files/drawing/dxf_entities.h"

#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace keyblock {

struct DxfCircle {
    Point center{0.0, 0.0};
    double radius = 0.0;
};
/// Part of an ellipse: center + cos t·p + sin t·q for t from start over sweep [rad].
struct DxfArc {
    Point center{0.0, 0.0}, p{0.0, 0.0}, q{0.0, 0.0};
    double start = 0.0, sweep = 0.0;
};
struct DxfVertex {
    Point place{0.0, 0.0};
    double bulge = 0.0;  // of the piece that begins here
};
struct DxfPolyline {
    std::vector<DxfVertex> vertices;
    bool closed = false;
};
struct DxfSpline {
    Spline spline;
    std::vector<Point> fit;  // used where there are no control points
    bool closed = false;
};
struct DxfInsert {
    std::string block;
    Point place{0.0, 0.0};
    double scaleX = 1.0, scaleY = 1.0;
    double angle = 0.0;  // [rad]
    int columns = 1, rows = 1;
    double columnSpacing = 0.0, rowSpacing = 0.0;
};
using DxfShape = std::variant<DxfCircle, DxfArc, DxfPolyline, DxfSpline, DxfInsert>;

struct DxfShapeReading {
    std::optional<DxfShape> shape;
    bool mirrored = false;  // drawn on a plane that is seen from behind: x counts to the left
    std::string why;  // there is none
    double height = 0.0;  // z of largest magnitude, which is left out
};

/// Reads LINE, LWPOLYLINE, POLYLINE, ARC, CIRCLE, ELLIPSE, SPLINE and INSERT; other kinds have a reason and no shape.
DxfShapeReading readDxfShape(const DxfEntity& entity);

}  // namespace keyblock
