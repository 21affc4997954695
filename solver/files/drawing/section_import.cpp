// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The scene is built, written, read and checked like any other scene; errors are
// reported at the line of the drawing from which they come.
#include "solver/files/drawing/section_import.h"

#include "geometry/polygon.h"
#include "solver/files/scene/bolt_library.h"
#include "solver/files/drawing/closed_outlines.h"
#include "solver/files/drawing/dxf_entities.h"
#include "solver/files/drawing/layer_roles.h"
#include "solver/scene/number_text.h"
#include "solver/scene/pointer.h"
#include "solver/scene/suggest.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

namespace keyblock {

namespace {

constexpr const char* assumedRock = "assumed-rock";
constexpr const char* assumedJoint = "assumed-joint";
constexpr const char* assumedBolt = "assumed-bolt";
constexpr const char* assumedBoltLike = "rebar-20";
constexpr double flatBox = 0.01;  // ratio of the sides below which a bounding box is flat
constexpr double meetingEnds = 1e-6;  // fraction of the size of the lines: ends closer than this are the same point

class Importer {
public:
    Importer(Drawing drawing, const ImportSettings& settings, const std::string& name)
        : drawing_(std::move(drawing)), settings_(settings), name_(name) {}

    Import build() {
        import_.problems = drawing_.problems;
        if (hasErrors(import_.problems) || !chooseUnit() || !hasLines()) return finished();
        scaleLines();
        import_.layers = layerRoles(drawing_, settings_, import_.problems);
        if (hasErrors(import_.problems)) return finished();
        sortByRole();
        if (lines_.empty())
            error(0, "every layer with lines is ignored, so no scene can be created",
                  "Give one of them a role with --role LAYER=joint|boundary|tunnel|bolt");
        else
            buildScene();
        if (!hasErrors(import_.problems)) checkScene();
        return finished();
    }

private:
    void error(int line, std::string message, std::string remedy) {
        addProblem(import_.problems, {Severity::Error, "", line, "", std::move(message), std::move(remedy)});
    }

    bool chooseUnit() {
        unit_ = settings_.unit ? settings_.unit : drawing_.unit;
        if (!unit_)
            error(0, "the drawing does not specify its units ($INSUNITS)", "Give --units, one of " + lengthUnitWords());
        else
            import_.unit = std::string(unit_->text) + (settings_.unit ? " (as given)" : " (from the file)");
        return unit_ != nullptr;
    }

    bool hasLines() {
        if (drawing_.lines.empty())
            error(0, "the file contains no line that can be imported",
                  drawing_.notTaken.empty() ? "Draw lines, polylines, arcs, circles or splines in the model"
                                            : "See why each entity was skipped");
        return !drawing_.lines.empty();
    }

    void scaleLines() {
        for (DrawnLine& line : drawing_.lines) {
            for (Point& p : line.points) p = {toSi(p.x(), unit_->unit), toSi(p.y(), unit_->unit)};
            if (line.circle) {
                line.circle->center = {toSi(line.circle->center.x(), unit_->unit),
                                       toSi(line.circle->center.y(), unit_->unit)};
                line.circle->radius = toSi(line.circle->radius, unit_->unit);
            }
        }
    }

    LayerRole roleOf(const DrawnLine& line) const {
        const auto found = std::find_if(import_.layers.begin(), import_.layers.end(), [&](const ImportedLayer& layer) {
            return lowerCase(layer.name) == lowerCase(line.layer);
        });
        return found->role;
    }

    /// Sorts lines by role and omits duplicates within a role.
    void sortByRole() {
        std::map<std::pair<LayerRole, std::vector<std::pair<double, double>>>, int> seen;
        for (DrawnLine& line : drawing_.lines) {
            const LayerRole role = roleOf(line);
            if (role == LayerRole::Ignore) {
                count(line, "ignored");
                continue;
            }
            std::vector<std::pair<double, double>> key, back;
            for (const Point& p : line.points) key.emplace_back(p.x(), p.y());
            back.assign(key.rbegin(), key.rend());
            const auto [first, fresh] = seen.emplace(std::pair{role, std::min(key, back)}, line.place.line);
            if (fresh)
                lines_[role].push_back(std::move(line));
            else
                refuse(line, "it repeats the entity in line " + std::to_string(first->second));
        }
    }

    void count(const DrawnLine& line, const std::string& became) { ++rows_[{line.kind, line.layer, became}]; }

    void refuse(const DrawnLine& line, std::string why) {
        drawing_.notTaken.push_back({line.kind, line.layer, line.place, std::move(why)});
    }

    void buildScene() {
        const std::string file = std::filesystem::path(name_).filename().string();
        scene_.title = "Imported from " + file;
        scene_.about.source = "imported from " + file;
        scene_.materials = {{assumedRock, {2700.0, 50e9, 0.25}}};
        scene_.jointMaterials = {{assumedJoint, JointMaterial{}}};
        assume("material 'assumed-rock' (2700 kg/m³, 50 GPa, 0.25) and joint material 'assumed-joint' (friction 30°): "
               "replace them with measured values");
        scene_.analysis.gravity = {0.0, -9.81};
        assume("gravity of 9.81 m/s² downwards, along -y");
        addTunnels();
        addJoints();
        addBoundary();
        if (!hasErrors(import_.problems)) addBolts();
    }

    void assume(std::string what) { import_.assumed.push_back(std::move(what)); }

    /// Makes a name that no other object of the scene has.
    std::string freeName(const std::string& wanted) {
        std::string name = wanted;
        for (int& number = numbers_.try_emplace(wanted, 1).first->second; !names_.insert(name).second;)
            name = wanted + "-" + std::to_string(++number);
        return name;
    }

    /// Larger side of the bounding box of the lines that are not closed: a large circle elsewhere must not widen the
    /// distance within which their ends meet.
    static double sizeOfOpen(const std::vector<DrawnLine>& lines) {
        std::vector<Point> points;
        for (const DrawnLine& line : lines)
            if (!line.closed) points.insert(points.end(), line.points.begin(), line.points.end());
        if (points.empty()) return 0.0;
        const Box box = boxOf(points);
        return (box.max - box.min).maxCoeff();
    }

    std::vector<ClosedOutline> outlines(LayerRole role, const std::string& what) {
        const std::vector<DrawnLine>& lines = lines_[role];
        const ClosedOutlines closed = closeOutlines(lines, meetingEnds * sizeOfOpen(lines));
        for (const std::size_t i : closed.open) {
            const DrawnLine& line = lines[i];
            error(line.place.line,
                  "the " + line.kind + " on layer " + inQuotes(line.layer) + " from " + text(line.points.front()) +
                      " to " + text(line.points.back()) + " does not close an outline of " + what,
                  "Close it, or give its layer another role");
        }
        return closed.outlines;
    }

    static std::string text(const Point& p) { return "(" + coordinateText(p.x()) + ", " + coordinateText(p.y()) + ")"; }

    void addTunnels() {
        const std::vector<DrawnLine>& lines = lines_[LayerRole::Tunnel];
        for (const ClosedOutline& outline : outlines(LayerRole::Tunnel, "a tunnel")) {
            const DrawnLine& first = lines[outline.lines.front()];
            SceneTunnel tunnel;
            tunnel.name = freeName(first.layer);
            if (first.circle) {
                tunnel.profile = ProfileKind::Circle;
                tunnel.center = first.circle->center;
                tunnel.diameter = 2.0 * first.circle->radius;
            } else {
                tunnel.profile = ProfileKind::Polygon;
                tunnel.points = outline.points;
            }
            const std::string became = first.circle ? "round tunnel" : "outline of a tunnel";
            for (const std::size_t i : outline.lines) count(lines[i], became);
            walls_.push_back(outline.points);
            origins_[under("/tunnels", scene_.tunnels.size())] = first.place.line;
            scene_.tunnels.push_back(std::move(tunnel));
        }
    }

    void addJoints() {
        for (const DrawnLine& line : lines_[LayerRole::Joint]) {
            SceneJoint joint;
            joint.name = freeName(line.name.empty() ? line.layer : line.name);
            joint.points = line.points;
            if (line.closed) joint.points.push_back(line.points.front());
            if (!line.material.empty()) joint.jointMaterial = jointMaterial(line.material);
            origins_[under("/joints", scene_.joints.size())] = line.place.line;
            scene_.joints.push_back(std::move(joint));
            count(line, "joint");
        }
    }

    std::string jointMaterial(const std::string& name) {
        const auto known = std::find_if(scene_.jointMaterials.begin(), scene_.jointMaterials.end(),
                                        [&](const auto& item) { return item.first == name; });
        if (known == scene_.jointMaterials.end()) {
            scene_.jointMaterials.emplace_back(name, JointMaterial{});
            assume("joint material " + inQuotes(name) + " has the friction of 'assumed-joint'");
        }
        return name;
    }

    void addBoundary() {
        const std::vector<DrawnLine>& lines = lines_[LayerRole::Boundary];
        const std::vector<ClosedOutline> found = outlines(LayerRole::Boundary, "the boundary");
        SceneDomain domain;
        domain.material = assumedRock;
        domain.jointMaterial = assumedJoint;
        if (found.size() > 1)
            return error(lines[found[1].lines.front()].place.line,
                         "the boundary has " + std::to_string(found.size()) +
                             " outlines, of which this is the second, but a scene has only one domain",
                         "Keep one, and give the layer of the others another role");
        if (found.empty()) {
            domain.boundary = assumedBoundary();
        } else {
            domain.boundary = found[0].points;
            origins_["/domain"] = lines[found[0].lines.front()].place.line;
            for (const std::size_t i : found[0].lines) count(lines[i], "boundary of the domain");
        }
        scene_.domain = std::move(domain);
    }

    /// Bounding box of the joints, which then cross it completely; without joints, a larger box with rock on all sides.
    std::vector<Point> assumedBoundary() {
        std::vector<Point> points;
        for (const auto& [role, lines] : lines_)
            for (const DrawnLine& line : lines) points.insert(points.end(), line.points.begin(), line.points.end());
        const bool tight = !lines_[LayerRole::Joint].empty();
        Box box = boxOf(points);
        const Point sides = box.max - box.min;
        if (!tight) box = grown(box, sides.maxCoeff());
        for (int axis = 0; axis < 2 && tight; ++axis)
            if (sides[axis] < flatBox * sides.maxCoeff()) {
                box.min[axis] -= 0.5 * sides.maxCoeff();
                box.max[axis] += 0.5 * sides.maxCoeff();
            }
        assume(std::string("no layer is the boundary: the domain is the bounding box of everything imported") +
               (tight ? ", widened if it was flat" : ", with as much rock on every side"));
        return {box.min, {box.max.x(), box.min.y()}, box.max, {box.min.x(), box.max.y()}};
    }

    void addBolts() {
        const std::vector<DrawnLine>& lines = lines_[LayerRole::Bolt];
        bool chosen = false;
        for (const DrawnLine& line : lines) {
            if (line.closed || !isStraight(line.points)) {
                refuse(line, "a bolt must be a straight line");
                continue;
            }
            Bolt bolt;
            bolt.name = freeName(line.name.empty() ? line.layer : line.name);
            bolt.farEnd = line.points.front();
            bolt.head = line.points.back();
            if (!line.headLast && isHead(line.points.front(), line.points.back())) std::swap(bolt.farEnd, bolt.head);
            chosen = chosen || !line.headLast;
            bolt.type = line.boltType.empty() ? assumedBolt : line.boltType;
            bolt.spacingOutOfPlane = line.boltSpacing;
            bolt.pretension = line.pretension.value_or(0.0);
            origins_[under("/bolts", scene_.bolts.size())] = line.place.line;
            scene_.bolts.push_back(std::move(bolt));
            count(line, "bolt");
        }
        if (chosen)
            assume(std::string("the head of a bolt is the end nearer to ") +
                   (walls_.empty() ? "the boundary" : "a tunnel"));
        addBoltTypes();
    }

    static bool isStraight(const std::vector<Point>& points) {
        const Point along = points.back() - points.front();
        const double length = along.norm();
        return length > 0.0 && std::all_of(points.begin(), points.end(), [&](const Point& p) {
                   return std::abs(cross(along, p - points.front())) <= meetingEnds * length * length;
               });
    }

    /// True if `a` is closer to the wall than `b`.
    bool isHead(const Point& a, const Point& b) const {
        const auto distance = [&](const Point& p) {
            double nearest = walls_.empty() ? distanceToBoundary(scene_.domain->boundary, p) : INFINITY;
            for (const std::vector<Point>& wall : walls_) nearest = std::min(nearest, distanceToBoundary(wall, p));
            return nearest;
        };
        return distance(a) < distance(b);
    }

    void addBoltTypes() {
        const bool needed = std::any_of(scene_.bolts.begin(), scene_.bolts.end(),
                                        [](const Bolt& bolt) { return bolt.type == assumedBolt; });
        if (!needed) return;
        BoltType type = *findBuiltInBoltType(assumedBoltLike);
        type.name = assumedBolt;
        type.like = assumedBoltLike;
        type.builtIn = false;
        scene_.boltTypes.push_back(std::move(type));
        assume(std::string("bolts are of the type 'assumed-bolt', which is based on ") + assumedBoltLike);
    }

    int lineOf(const std::string& pointer) const {
        const auto end = pointer.find('/', pointer.find('/', 1) + 1);
        for (const std::string& place : {pointer.substr(0, end), pointer.substr(0, pointer.find('/', 1))})
            if (const auto found = origins_.find(place); found != origins_.end()) return found->second;
        return 0;
    }

    void checkScene() {
        SceneReading reading = readSceneText(sceneText(scene_), name_);
        for (Problem problem : reading.problems) {
            problem.line = lineOf(problem.pointer);
            addProblem(import_.problems, std::move(problem));
        }
        import_.scene = std::move(reading.scene);
        import_.cut = std::move(reading.cut);
    }

    Import finished() {
        if (hasErrors(import_.problems)) import_.scene.reset();
        for (Problem& problem : import_.problems) problem.file = name_;
        for (const InsertedBlock& item : drawing_.inserted)
            ++rows_[{item.kind, item.layer, "block " + inQuotes(item.block) + ", inserted"}];
        for (const NotTaken& item : drawing_.notTaken) ++rows_[{item.kind, item.layer, "skipped"}];
        for (const auto& [key, number] : rows_)
            import_.rows.push_back({std::get<0>(key), std::get<1>(key), std::get<2>(key), number});
        import_.notTaken = std::move(drawing_.notTaken);
        std::stable_sort(import_.notTaken.begin(), import_.notTaken.end(),
                         [](const NotTaken& a, const NotTaken& b) { return a.place.line < b.place.line; });
        return std::move(import_);
    }

    Drawing drawing_;
    const ImportSettings& settings_;
    std::string name_;
    Import import_;
    Scene scene_;
    const UnitSymbol* unit_ = nullptr;
    std::map<LayerRole, std::vector<DrawnLine>> lines_;
    std::map<std::tuple<std::string, std::string, std::string>, int> rows_;
    std::set<std::string> names_;
    std::map<std::string, int> numbers_;  // the last number that `freeName` tried for a name
    std::vector<std::vector<Point>> walls_;
    std::map<std::string, int> origins_;  // line numbers of the drawing by pointers into the scene
};

}  // namespace

Import importSection(Drawing drawing, const ImportSettings& settings, const std::string& name) {
    return Importer(std::move(drawing), settings, name).build();
}

}  // namespace keyblock
