// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Blocks are inserted by affine maps, which may include mirroring, stretching and
// repetition; curves are converted to points before they are mapped. The drawing is
// converted twice, first coarsely to find its size, from which the sagitta is chosen.
#include "solver/files/drawing/dxf_file.h"

#include "geometry/polygon.h"
#include "solver/files/drawing/dxf_shapes.h"
#include "solver/files/text_encoding.h"
#include "solver/scene/number_text.h"
#include "solver/scene/suggest.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <set>

namespace keyblock {

namespace {

constexpr std::size_t mostEntities = 200'000;  // including the entities of inserted blocks
constexpr std::size_t deepestInsert = 16;
constexpr double sagittaOfSize = 5e-4;

struct Map {
    Eigen::Matrix2d linear = Eigen::Matrix2d::Identity();
    Point shift{0.0, 0.0};

    Point operator()(const Point& p) const { return linear * p + shift; }
    Map operator*(const Map& inner) const { return {linear * inner.linear, linear * inner.shift + shift}; }
    /// Largest and smallest factor by which the map changes lengths: its singular values.
    std::pair<double, double> stretches() const {
        const double a = linear(0, 0), b = linear(0, 1), c = linear(1, 0), d = linear(1, 1);
        const double alike = 0.5 * std::hypot(a + d, c - b), apart = 0.5 * std::hypot(a - d, b + c);
        return {alike + apart, std::abs(alike - apart)};
    }
    double stretch() const { return stretches().first; }
    bool keepsCircles() const { return stretches().first - stretches().second <= 1e-12 * stretches().first; }
};

const Map fromBehind{(Eigen::Matrix2d() << -1.0, 0.0, 0.0, 1.0).finished(), {0.0, 0.0}};

const UnitSymbol* unitOfCode(int code) {
    static const std::array<std::pair<int, std::string_view>, 11> codes{{{1, "in"}, {2, "ft"}, {3, "mi"}, {4, "mm"},
        {5, "cm"}, {6, "m"}, {7, "km"}, {10, "yd"}, {13, "um"}, {14, "dm"}, {21, "us-ft"}}};
    for (const auto& [number, word] : codes)
        if (number == code) return lengthUnitOf(word);
    return nullptr;
}

/// Shapes that have been read, by entity: the entities of a block are drawn many times.
using Shapes = std::map<const DxfEntity*, DxfShapeReading>;

class Drawer {
public:
    Drawer(const DxfContent& content, Shapes& shapes, double sagitta)
        : content_(content), shapes_(shapes), sagitta_(sagitta) {}

    Drawing draw() {
        for (const DxfEntity& entity : content_.entities) add(entity, {}, "");
        tellHeights();
        tellUnusedBlocks();
        return std::move(drawing_);
    }

private:
    /// \param layer the layer of the insert to which the entity belongs; empty if there is none.
    void add(const DxfEntity& entity, const Map& map, const std::string& layer) {
        if (++entities_ > mostEntities) {
            if (entities_ == mostEntities + 1)
                drawing_.problems.push_back(
                    {Severity::Error, "", entity.line, "",
                     "the number of blocks and entities exceeds " + std::to_string(mostEntities),
                     drawing_.inserted.empty() ? "Export only the section"
                                               : "Insert fewer copies of blocks, or export only "
                                                 "the section"});
            return;
        }
        const std::string own = !layer.empty() && entity.layer == "0" ? layer : entity.layer;
        if (entity.paper) return refuse(entity, own, "it is drawn in paper space, not in the model");
        if (entity.invisible) return refuse(entity, own, "it is invisible");
        const DxfShapeReading& reading = shapeOf(entity);
        if (!reading.shape) return refuse(entity, own, reading.why);
        noteHeight(entity, reading.height);
        const Map placed = reading.mirrored ? map * fromBehind : map;
        if (const auto* insert = std::get_if<DxfInsert>(&*reading.shape))
            return addInsert(entity, *insert, placed, own);
        addLine(entity, *reading.shape, placed, own);
    }

    const DxfShapeReading& shapeOf(const DxfEntity& entity) {
        const auto known = shapes_.find(&entity);
        return known != shapes_.end() ? known->second : shapes_.emplace(&entity, readDxfShape(entity)).first->second;
    }

    void refuse(const DxfEntity& entity, const std::string& layer, std::string why) {
        drawing_.notTaken.push_back({kindOf(entity), layer, {entity.line, entity.handle}, std::move(why)});
    }

    std::string kindOf(const DxfEntity& entity) const {
        return stack_.empty() ? entity.kind
                              : entity.kind + " in block " + inQuotes(content_.blocks.at(stack_.back()).name);
    }

    void addLine(const DxfEntity& entity, const DxfShape& shape, const Map& map, const std::string& layer) {
        DrawnLine line;
        line.layer = layer;
        line.kind = kindOf(entity);
        line.place = {entity.line, entity.handle};
        line.points = pointsOf(shape, sagitta_ / std::max(map.stretch(), 1e-300), line);
        for (Point& p : line.points) p = map(p);
        if (const auto* circle = std::get_if<DxfCircle>(&shape); circle && map.keepsCircles())
            line.circle = {map(circle->center), circle->radius * map.stretch()};
        tidy(line);
        if (line.points.size() < 2) return refuse(entity, layer, "it has no length");
        if (!std::all_of(line.points.begin(), line.points.end(), [](const Point& p) { return p.allFinite(); }))
            return refuse(entity, layer, "its coordinates are too large");
        drawing_.lines.push_back(std::move(line));
    }

    static std::vector<Point> pointsOf(const DxfShape& shape, double sagitta, DrawnLine& line) {
        if (const auto* circle = std::get_if<DxfCircle>(&shape)) {
            line.closed = true;
            return ellipsePoints(circle->center, {circle->radius, 0.0}, {0.0, circle->radius}, 0.0,
                                 2.0 * std::numbers::pi, sagitta);
        }
        if (const auto* arc = std::get_if<DxfArc>(&shape)) {
            line.closed = arc->sweep > 2.0 * std::numbers::pi * (1.0 - 1e-12);
            return ellipsePoints(arc->center, arc->p, arc->q, arc->start, arc->sweep, sagitta);
        }
        if (const auto* drawn = std::get_if<DxfSpline>(&shape)) {
            line.closed = drawn->closed;
            if (drawn->spline.control.empty()) line.kind += " (straight between its fit points)";
            return drawn->spline.control.empty() ? drawn->fit : splinePoints(drawn->spline, sagitta);
        }
        const auto& polyline = std::get<DxfPolyline>(shape);
        line.closed = polyline.closed;
        return pointsOf(polyline, sagitta);
    }

    static std::vector<Point> pointsOf(const DxfPolyline& polyline, double sagitta) {
        std::vector<Point> points;
        const std::size_t count = polyline.vertices.size();
        for (std::size_t i = 0; i < count; ++i) {
            const DxfVertex& from = polyline.vertices[i];
            const bool last = i + 1 == count;
            if (points.empty()) points.push_back(from.place);
            if (last && !polyline.closed) break;
            const std::vector<Point> piece =
                bulgePoints(from.place, polyline.vertices[last ? 0 : i + 1].place, from.bulge, sagitta);
            points.insert(points.end(), piece.begin() + 1, piece.end());
        }
        return points;
    }

    /// Removes points that repeat the previous one and, in a closed line, a last point that repeats the first.
    static void tidy(DrawnLine& line) {
        const Box box = line.points.empty() ? Box{} : boxOf(line.points);
        const double same = 1e-12 * (box.max - box.min).norm();
        const auto near = [&](const Point& a, const Point& b) { return (a - b).norm() <= same; };
        line.points.erase(std::unique(line.points.begin(), line.points.end(), near), line.points.end());
        const bool meets = line.points.size() > 3 && near(line.points.front(), line.points.back());
        if (line.closed || meets) {
            line.closed = true;
            while (line.points.size() > 1 && near(line.points.front(), line.points.back())) line.points.pop_back();
        }
        if (line.points.size() < 3) line.closed = false;
    }

    void addInsert(const DxfEntity& entity, const DxfInsert& insert, const Map& map, const std::string& layer) {
        const std::string name = nameOf(insert.block), key = lowerCase(name);
        const auto block = content_.blocks.find(key);
        for (const DxfEntity& part : entity.parts) refuse(part, layer, "text is not geometry");
        if (block == content_.blocks.end()) return refuse(entity, layer, "there is no block " + inQuotes(name));
        if (std::count(stack_.begin(), stack_.end(), key) > 0)
            return refuse(entity, layer, "the block " + inQuotes(name) + " would be inserted into itself");
        if (stack_.size() >= deepestInsert)
            return refuse(entity, layer, "blocks are inserted into blocks more than " + std::to_string(deepestInsert) +
                                             " levels deep");
        if (insert.scaleX == 0.0 || insert.scaleY == 0.0) return refuse(entity, layer, "its scale is 0");
        if (block->second.entities.empty()) return refuse(entity, layer, "the block " + inQuotes(name) + " is empty");
        drawing_.inserted.push_back({kindOf(entity), layer, block->second.name});
        used_.insert(key);
        stack_.push_back(key);
        for (int row = 0; row < std::max(1, insert.rows) && entities_ <= mostEntities; ++row)
            for (int column = 0; column < std::max(1, insert.columns) && entities_ <= mostEntities; ++column)
                addCopy(block->second, insert, map, layer, row, column);
        stack_.pop_back();
    }

    void addCopy(const DxfBlock& block, const DxfInsert& insert, const Map& map, const std::string& layer, int row,
                 int column) {
        const double c = std::cos(insert.angle), s = std::sin(insert.angle);
        Eigen::Matrix2d turn;
        turn << c, -s, s, c;
        if (insert.angle == 0.0) turn.setIdentity();
        Map copy{turn * Eigen::DiagonalMatrix<double, 2>(insert.scaleX, insert.scaleY), insert.place};
        copy.shift += turn * Point(column * insert.columnSpacing, row * insert.rowSpacing) - copy.linear * block.base;
        for (const DxfEntity& entity : block.entities) add(entity, map * copy, layer);
    }

    /// Decodes a name in the same way as the names of blocks.
    std::string nameOf(const std::string& raw) const { return withDxfEscapes(asUtf8(raw, content_.codePage)); }

    void noteHeight(const DxfEntity& entity, double height) {
        if (height == 0.0) return;
        if (heights_++ == 0) firstHeight_ = entity.line;
        highest_ = std::max(highest_, std::abs(height));
    }

    void tellHeights() {
        if (heights_ == 0) return;
        drawing_.problems.push_back(
            {Severity::Warning, "", firstHeight_, "",
             "heights z of up to " + rounded(highest_) +
                 " were ignored, first here; number of entities with such heights: " + std::to_string(heights_),
             "Check that the section is drawn in x and y"});
    }

    void tellUnusedBlocks() {
        for (const auto& [key, block] : content_.blocks) {
            const bool ofProgram = block.name.starts_with('*');  // used for sheets, dimensions and hatches
            if (!used_.contains(key) && !block.entities.empty() && !ofProgram)
                addProblem(drawing_.problems,
                           {Severity::Note, "", block.line, "",
                            "the block " + inQuotes(block.name) + " is never inserted; entities in it: " +
                                std::to_string(block.entities.size()),
                            "Insert it if it is needed"});
        }
    }

    const DxfContent& content_;
    Shapes& shapes_;
    double sagitta_;
    Drawing drawing_;
    std::vector<std::string> stack_;  // keys of the blocks that are being inserted
    std::set<std::string> used_;
    std::size_t entities_ = 0;
    int heights_ = 0, firstHeight_ = 0;
    double highest_ = 0.0;
};

double sizeOf(const Drawing& drawing) {
    std::vector<Point> points;
    for (const DrawnLine& line : drawing.lines) {
        const Box box = boxOf(line.points);
        points.insert(points.end(), {box.min, box.max});
    }
    if (points.empty()) return 1.0;
    const Box box = boxOf(points);
    return std::max((box.max - box.min).maxCoeff(), std::numeric_limits<double>::min());
}

}  // namespace

Drawing readDxf(std::string_view text, std::optional<double> sagitta) {
    const DxfGroups groups = readDxfGroups(text);
    Drawing drawing;
    drawing.problems = groups.problems;
    if (hasErrors(groups.problems)) return drawing;
    const DxfContent content = sortDxf(groups);
    Shapes shapes;
    if (!sagitta) {
        drawing = Drawer(content, shapes, std::numeric_limits<double>::max()).draw();
        sagitta = sagittaOfSize * sizeOf(drawing);
    }
    if (!hasErrors(drawing.problems)) drawing = Drawer(content, shapes, *sagitta).draw();
    drawing.problems.insert(drawing.problems.begin(), content.problems.begin(), content.problems.end());
    drawing.unit = unitOfCode(content.units);
    for (const auto& [layer, hidden] : content.hidden)
        if (hidden) drawing.hiddenLayers.push_back(layer);
    return drawing;
}

}  // namespace keyblock
