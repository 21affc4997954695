// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The groups of an entity are checked: values are numbers, all codes that its kind
// requires are present, and there are as many y as x. They are then written again in
// the order and with the counts that the library relies on, and read by it. Its
// results are converted to shapes.
#include "solver/files/drawing/dxf_shapes.h"

#include "solver/files/csv/number_text_reader.h"
#include "solver/scene/suggest.h"

#include <dl_creationadapter.h>
#include <dl_dxf.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <sstream>

namespace keyblock {

namespace {

constexpr double degrees = std::numbers::pi / 180.0;
constexpr double fullTurn = 2.0 * std::numbers::pi;
constexpr std::size_t mostGroups = 4'000'000;  // maximum for one entity

/// Codes of a kind of entity: the required and the optional ones.
struct ShapeKind {
    std::vector<int> needed, optional;
    bool turned = true;  // drawn on a plane of its own, which may be viewed from behind
};

const std::map<std::string, ShapeKind, std::less<>>& kinds() {
    static const std::map<std::string, ShapeKind, std::less<>> all{
        {"LINE", {{10, 20, 11, 21}, {30, 31}, false}},
        {"LWPOLYLINE", {{10, 20}, {38, 42, 70}}},
        {"POLYLINE", {{}, {30, 70}}},
        {"VERTEX", {{10, 20}, {30, 42, 70}}},
        {"ARC", {{10, 20, 40, 50, 51}, {30}}},
        {"CIRCLE", {{10, 20, 40}, {30}}},
        {"ELLIPSE", {{10, 20, 11, 21, 40, 41, 42}, {30, 31}, false}},
        {"SPLINE", {{71}, {10, 20, 30, 11, 21, 31, 40, 41, 70}, false}},
        {"INSERT", {{10, 20}, {30, 41, 42, 43, 44, 45, 50, 70, 71}}}};
    return all;
}

std::string reasonFor(std::string_view kind) {
    static const std::map<std::string, std::string, std::less<>> reasons{
        {"TEXT", "text is not geometry"},          {"MTEXT", "text is not geometry"},
        {"ATTDEF", "text is not geometry"},        {"ATTRIB", "text is not geometry"},
        {"DIMENSION", "a dimension is not geometry"}, {"LEADER", "a leader is not geometry"},
        {"MULTILEADER", "a leader is not geometry"}, {"HATCH", "a hatch has no lines of its own"},
        {"POINT", "a point does not bound a block"},      {"SOLID", "filled areas are not imported; draw their outlines"},
        {"TRACE", "filled areas are not imported; draw their outlines"},
        {"3DFACE", "3D faces are not imported; draw their outlines"},
        {"XLINE", "it is infinite; draw a line"},  {"RAY", "it is infinite; draw a line"},
        {"IMAGE", "an image is not geometry"},    {"VIEWPORT", "a viewport is not geometry"},
        {"MLINE", "multilines are not read; explode them into lines"},
        {"VERTEX", "it is outside a POLYLINE"}, {"SEQEND", "it has no entity to end"}};
    const auto found = reasons.find(kind);
    return found == reasons.end() ? "entities of this kind are not read" : found->second;
}

/// Receives the entities from the library.
class Listener : public DL_CreationAdapter {
public:
    void addLine(const DL_LineData& d) override {
        shape = DxfPolyline{{{{d.x1, d.y1}}, {{d.x2, d.y2}}}, false};
    }
    void addArc(const DL_ArcData& d) override {
        double sweep = std::fmod(d.angle2 - d.angle1, 360.0);
        if (sweep <= 0.0) sweep += 360.0;
        shape = DxfArc{{d.cx, d.cy}, {d.radius, 0.0}, {0.0, d.radius}, d.angle1 * degrees, sweep * degrees};
    }
    void addCircle(const DL_CircleData& d) override { shape = DxfCircle{{d.cx, d.cy}, d.radius}; }
    void addEllipse(const DL_EllipseData& d) override {
        double sweep = std::fmod(d.angle2 - d.angle1, fullTurn);
        if (sweep <= 1e-12) sweep += fullTurn;
        shape = DxfArc{{d.cx, d.cy}, {d.mx, d.my}, {-d.ratio * d.my, d.ratio * d.mx}, d.angle1, sweep};
    }
    void addPolyline(const DL_PolylineData& d) override { shape = DxfPolyline{{}, (d.flags & 1) != 0}; }
    void addVertex(const DL_VertexData& d) override {
        if (shape)
            if (auto* line = std::get_if<DxfPolyline>(&*shape)) line->vertices.push_back({{d.x, d.y}, d.bulge});
    }
    void addSpline(const DL_SplineData& d) override {
        DxfSpline drawn;
        drawn.spline.degree = static_cast<int>(d.degree);
        drawn.closed = (d.flags & 1) != 0;
        shape = drawn;
    }
    void addKnot(const DL_KnotData& d) override {
        if (DxfSpline* drawn = spline()) drawn->spline.knots.push_back(d.k);
    }
    void addControlPoint(const DL_ControlPointData& d) override {
        if (DxfSpline* drawn = spline()) {
            drawn->spline.control.emplace_back(d.x, d.y);
            drawn->spline.weights.push_back(d.w);
        }
    }
    void addFitPoint(const DL_FitPointData& d) override {
        if (DxfSpline* drawn = spline()) drawn->fit.emplace_back(d.x, d.y);
    }
    void addInsert(const DL_InsertData& d) override {
        shape = DxfInsert{"", {d.ipx, d.ipy}, d.sx, d.sy, d.angle * degrees, d.cols, d.rows, d.colSp, d.rowSp};
    }

    std::optional<DxfShape> shape;

private:
    DxfSpline* spline() { return shape ? std::get_if<DxfSpline>(&*shape) : nullptr; }
};

bool isOf(const ShapeKind& kind, int code) {
    return std::count(kind.needed.begin(), kind.needed.end(), code) > 0 ||
           std::count(kind.optional.begin(), kind.optional.end(), code) > 0;
}

int countOf(const DxfEntity& entity, int code) {
    return static_cast<int>(std::count_if(entity.groups.begin(), entity.groups.end(),
                                          [&](const DxfGroup& group) { return group.code == code; }));
}

/// Reason why an entity cannot be passed to the library; empty if there is none.
std::string faultOf(const DxfEntity& entity, const ShapeKind& kind) {
    if (entity.groups.size() > mostGroups) return "it has more than " + std::to_string(mostGroups) + " values";
    for (const DxfGroup& group : entity.groups) {
        double real = 0.0;
        int integer = 0;
        if (!isOf(kind, group.code)) continue;
        if (group.value.size() > 64 || !(isRealCode(group.code) ? readReal(group.value, real)
                                                                : readInteger(group.value, integer)))
            return "its value for code " + std::to_string(group.code) + " in line " + std::to_string(group.line) +
                   " is " + inQuotes(group.value) + ", which is not a usable number";
    }
    for (const int code : kind.needed)
        if (countOf(entity, code) == 0) return "it has no code " + std::to_string(code);
    for (const auto& [x, y] : {std::pair{10, 20}, std::pair{11, 21}})
        if (isOf(kind, x) && countOf(entity, x) != countOf(entity, y))
            return "it has " + std::to_string(countOf(entity, x)) + " x and " + std::to_string(countOf(entity, y)) +
                   " y";
    if (entity.kind != "SPLINE" && entity.kind != "LWPOLYLINE")
        for (const int code : kind.needed)
            if (countOf(entity, code) > 1) return "code " + std::to_string(code) + " is given twice";
    return {};
}

void put(std::string& text, int code, std::string_view value) {
    text += std::to_string(code) + '\n' + std::string(value) + '\n';
}

/// Writes the counts first, and then the groups of the shape in their order.
void writeEntity(const DxfEntity& entity, const ShapeKind& kind, std::string& text) {
    put(text, 0, entity.kind);
    if (entity.kind == "LWPOLYLINE") put(text, 90, std::to_string(countOf(entity, 10)));
    if (entity.kind == "SPLINE") {
        put(text, 72, std::to_string(countOf(entity, 40)));
        put(text, 73, std::to_string(countOf(entity, 10)));
        put(text, 74, std::to_string(countOf(entity, 11)));
    }
    if (entity.kind == "INSERT") put(text, 2, "named elsewhere");
    for (const DxfGroup& group : entity.groups)
        if (isOf(kind, group.code)) put(text, group.code, group.value);
}

std::optional<DxfShape> readByLibrary(const std::string& text) {
    std::istringstream stream(text + "0\nEOF\n");
    DL_Dxf library;
    Listener listener;
    while (library.readDxfGroups(stream, &listener)) {
    }
    return std::move(listener.shape);
}

/// True for vertices of the line itself; false for the control points that a fitted line has in addition.
bool isOnLine(const DxfEntity& vertex) { return (integerOf(vertex, 70, 0) & 16) == 0; }

std::string faultOfPolyline(const DxfEntity& entity) {
    if ((integerOf(entity, 70, 0) & (16 | 64)) != 0) return "a 3D mesh is not a line";
    for (const DxfEntity& vertex : entity.parts)
        if (const std::string fault = faultOf(vertex, kinds().at("VERTEX")); !fault.empty())
            return "of its vertex in line " + std::to_string(vertex.line) + ": " + fault;
    return entity.parts.empty() ? "it has no vertices" : "";
}

double heightOf(const DxfEntity& entity) {
    double height = 0.0;
    for (const DxfGroup& group : entity.groups) {
        double z = 0.0;
        const bool isHeight = group.code == 30 || group.code == 31 || group.code == 38;
        if (isHeight && readReal(group.value, z) && std::abs(z) > std::abs(height)) height = z;
    }
    return height;
}

/// Describes what is wrong with the plane on which an entity is drawn; empty if nothing is.
std::string faultOfPlane(const DxfEntity& entity) {
    const double x = realOf(entity, 210, 0.0), y = realOf(entity, 220, 0.0), z = realOf(entity, 230, 1.0);
    constexpr double flat = 1e-9;
    if (std::max(std::abs(x), std::abs(y)) > flat * std::abs(z)) return "it is drawn on an inclined plane";
    return {};
}

std::string faultOfShape(const DxfShape& shape) {
    if (const auto* circle = std::get_if<DxfCircle>(&shape); circle && !(circle->radius > 0.0))
        return "its radius is not above 0";
    if (const auto* arc = std::get_if<DxfArc>(&shape); arc && !(arc->p.norm() > 0.0 && arc->q.norm() > 0.0))
        return "it has no size";
    if (const auto* drawn = std::get_if<DxfSpline>(&shape))
        return drawn->spline.control.empty() && drawn->fit.size() >= 2 ? "" : splineProblem(drawn->spline);
    return {};
}

DxfShapeReading refused(std::string why) { return {std::nullopt, false, std::move(why), 0.0}; }

}  // namespace

DxfShapeReading readDxfShape(const DxfEntity& entity) {
    const auto kind = kinds().find(entity.kind);
    if (kind == kinds().end() || entity.kind == "VERTEX") return refused(reasonFor(entity.kind));
    std::string fault = faultOf(entity, kind->second);
    if (fault.empty() && entity.kind == "POLYLINE") fault = faultOfPolyline(entity);
    const bool inSpace = entity.kind == "POLYLINE" && (integerOf(entity, 70, 0) & 8) != 0;
    const bool turned = kind->second.turned && !inSpace;
    if (fault.empty() && (turned || entity.kind == "ELLIPSE")) fault = faultOfPlane(entity);
    if (!fault.empty()) return refused(fault);

    std::string text;
    writeEntity(entity, kind->second, text);
    DxfShapeReading reading;
    reading.height = heightOf(entity);
    for (const DxfEntity& vertex : entity.parts) {
        if (entity.kind != "POLYLINE" || !isOnLine(vertex)) continue;
        writeEntity(vertex, kinds().at("VERTEX"), text);
        if (const double z = heightOf(vertex); std::abs(z) > std::abs(reading.height)) reading.height = z;
    }
    if (entity.kind == "POLYLINE") put(text, 0, "SEQEND");
    reading.shape = readByLibrary(text);
    if (!reading.shape) return refused("it could not be read");
    if (fault = faultOfShape(*reading.shape); !fault.empty()) return refused(fault);
    const bool behind = realOf(entity, 230, 1.0) < 0.0;
    reading.mirrored = turned && behind;
    if (auto* ellipse = std::get_if<DxfArc>(&*reading.shape); ellipse && entity.kind == "ELLIPSE" && behind)
        ellipse->q = -ellipse->q;
    if (auto* insert = std::get_if<DxfInsert>(&*reading.shape)) insert->block = valueOf(entity, 2);
    return reading;
}

}  // namespace keyblock
