// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One entity of a DXF file as plain values. The numbers of an entity are read by
// libdxflib, which takes missing values as 0 and trusts every count. Each entity is
// therefore checked first, including its counts, and passed to the library on its own
// and only with the groups that describe its shape. Headers, tables, texts and all
// other kinds of entity never reach the library.
#pragma once

#include "geometry/shape/curve.h"
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
/// Arc of an ellipse: center + cos t·p + sin t·q for t from start to start + sweep [rad].
struct DxfArc {
    Point center{0.0, 0.0}, p{0.0, 0.0}, q{0.0, 0.0};
    double start = 0.0, sweep = 0.0;
};
struct DxfVertex {
    Point place{0.0, 0.0};
    double bulge = 0.0;  // bulge of the segment that begins at this vertex
};
struct DxfPolyline {
    std::vector<DxfVertex> vertices;
    bool closed = false;
};
struct DxfSpline {
    Spline spline;
    std::vector<Point> fit;  // fit points, used if there are no control points
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
    bool mirrored = false;  // drawn on a plane seen from behind, with x increasing to the left
    std::string why;  // reason why there is no shape
    double height = 0.0;  // z coordinate of largest magnitude; z coordinates are otherwise ignored
};

/// Reads LINE, LWPOLYLINE, POLYLINE, ARC, CIRCLE, ELLIPSE, SPLINE and INSERT; for other entities the result contains a
/// reason instead of a shape.
DxfShapeReading readDxfShape(const DxfEntity& entity);

}  // namespace keyblock
