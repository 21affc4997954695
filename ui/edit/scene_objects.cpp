// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/edit/scene_objects.h"

#include "geometry/angle.h"
#include "geometry/cells/voronoi.h"
#include "geometry/polygon.h"
#include "solver/scene/lookup.h"
#include "solver/scene/pointer.h"
#include "solver/scene/shapes.h"
#include "ui/edit/defaults.h"
#include "ui/edit/names.h"

#include <algorithm>

namespace keyblock {
namespace {

constexpr double mostShownBolts = 10000.0;
constexpr double signLength = 3.0;  // in units of the spacing of a joint set

bool allUsable(const std::vector<Point>& points) { return std::all_of(points.begin(), points.end(), isUsable); }

/// The area in which traces may lie; null if it is not an outline.
const std::vector<Point>* regionOf(const Scene& scene, const std::optional<std::string>& name) {
    const SceneRegion* region = name ? findRegion(scene, *name) : nullptr;
    const std::vector<Point>* points = region ? &region->points : !name && scene.domain ? &scene.domain->boundary : nullptr;
    return points && outlineProblem(*points).empty() ? points : nullptr;
}

double toleranceIn(const std::vector<Point>& region) {
    const Box box = boxOf(region);
    return 1e-6 * (box.max - box.min).maxCoeff();
}

/// Collects the objects in order.
class ObjectCollector {
public:
    explicit ObjectCollector(const Scene& scene) : scene_(scene) {}

    std::vector<SceneObject> collect() {
        section();
        each(scene_.tunnels, "/tunnels", ObjectKind::Tunnel, [&](const auto& tunnel, auto& out) { draw(tunnel, out); });
        each(scene_.blocks, "/blocks", ObjectKind::Block, [&](const auto& block, auto& out) { outlineOf(block.points, out); });
        each(scene_.supports, "/supports", ObjectKind::Support, [&](const auto& support, auto& out) { draw(support, out); });
        each(scene_.bolts, "/bolts", ObjectKind::Bolt, [&](const Bolt& bolt, SceneObject& out) {
            if (isUsable(bolt.head) && isUsable(bolt.farEnd)) out.lines.push_back({{bolt.head, bolt.farEnd}});
        });
        each(scene_.boltPatterns, "/bolt_patterns", ObjectKind::Pattern, [&](const ScenePattern& pattern, SceneObject& out) {
            out.lines = boltsOfPattern(scene_, pattern);
            if (out.lines.empty() && isUsable(pattern.from)) out.marks.push_back(pattern.from);
        });
        for (std::size_t i = 0; i < scene_.stages.size(); ++i) stage(scene_.stages[i], under("/stages", i));
        each(scene_.monitors, "/monitors", ObjectKind::Monitor, [](const Monitor& monitor, SceneObject& out) {
            if (monitor.point && isUsable(*monitor.point)) out.marks.push_back(*monitor.point);
            if (monitor.between && isUsable((*monitor.between)[0]) && isUsable((*monitor.between)[1]))
                out.lines.push_back({{(*monitor.between)[0], (*monitor.between)[1]}});
        });
        return std::move(found_);
    }

private:
    template <typename Items, typename Draw>
    void each(const Items& items, const std::string& list, ObjectKind kind, Draw drawItem) {
        for (std::size_t i = 0; i < items.size(); ++i) add(under(list, i), kind, [&](SceneObject& out) { drawItem(items[i], out); });
    }

    template <typename Draw>
    void add(const std::string& pointer, ObjectKind kind, Draw drawIt) {
        SceneObject object{pointer, kind, titleAt(scene_, pointer), {}, {}, {}, {}};
        drawIt(object);
        if (!object.lines.empty() || !object.marks.empty()) found_.push_back(std::move(object));
    }

    static void outlineOf(const std::vector<Point>& points, SceneObject& out) {
        if (points.size() < 3 || !allUsable(points)) return;
        out.lines.push_back({points, true});
        out.area = points;
    }

    void section() {
        if (scene_.domain)
            add("/domain", ObjectKind::Domain, [&](SceneObject& out) {
                outlineOf(scene_.domain->boundary, out);
                out.area.clear();
            });
        each(scene_.regions, "/regions", ObjectKind::Region, [&](const auto& region, auto& out) {
            outlineOf(region.points, out);
            out.area.clear();
        });
        each(scene_.joints, "/joints", ObjectKind::Joint, [](const SceneJoint& joint, SceneObject& out) {
            if (joint.points.size() >= 2 && allUsable(joint.points)) out.lines.push_back({joint.points});
        });
        each(scene_.jointSets, "/joint_sets", ObjectKind::JointSet, [&](const SceneJointSet& set, SceneObject& out) {
            out.lines = tracesOfSet(scene_, set);
            if (out.lines.empty()) sign(set, out);
        });
        if (scene_.voronoi) add("/voronoi", ObjectKind::Voronoi, [&](SceneObject& out) { voronoi(out); });
    }

    static void sign(const SceneJointSet& set, SceneObject& out) {
        if (!isUsable(set.origin) || !std::isfinite(set.dip)) return;
        const double length = set.spacing > 0.0 && set.spacing < 1e6 ? signLength * set.spacing : 1.0;
        const Point along = 0.5 * length * directionOf(set.dip);
        out.lines.push_back({{set.origin - along, set.origin + along}});
    }

    void voronoi(SceneObject& out) const {
        const SceneVoronoi& cells = *scene_.voronoi;
        const std::vector<Point>* region = regionOf(scene_, cells.region);
        if (!region || !(cells.size > 0.0) || !std::isfinite(cells.size)) return;
        if (voronoiEstimate(*region, cells.size) > mostShownTraces) {
            out.lines.push_back({*region, true});
            return;
        }
        const auto seed = static_cast<std::uint64_t>(cells.seed);
        for (const Segment& edge : voronoiCells(*region, cells.size, seed, toleranceIn(*region)).edges)
            out.lines.push_back({{edge.from, edge.to}});
    }

    static void draw(const SceneTunnel& tunnel, SceneObject& out) {
        if (!isUsable(tunnel.center) || !allUsable(tunnel.points) || profileProblem(shapeOf(tunnel))) return;
        const TunnelProfile profile = tunnelProfile(shapeOf(tunnel));
        for (const ProfilePiece& piece : profile.pieces) {
            ObjectLine line;
            line.curved = piece.arc.has_value();
            for (int i = 0; i <= piece.edges; ++i) line.points.push_back(cornerOf(piece, i));
            out.lines.push_back(std::move(line));
        }
        out.area = outline(profile);
        if (tunnel.profile != ProfileKind::Polygon) out.middles.push_back(tunnel.center);
    }

    void draw(const Support& support, SceneObject& out) const {
        for (const auto& place : {support.blockAt, support.point})
            if (place && isUsable(*place)) out.marks.push_back(*place);
        if (!support.boundary || !scene_.domain || !outlineProblem(scene_.domain->boundary).empty()) return;
        const std::vector<Point> corners = counterClockwise(scene_.domain->boundary);
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const Point &from = corners[i], &to = corners[(i + 1) % corners.size()];
            if (support.boundary == BoundarySide::All || sideOf(from, to) == support.boundary)
                out.lines.push_back({{from, to}});
        }
    }

    void stage(const Stage& stage, const std::string& pointer) {
        each(stage.motions, under(pointer, "motions"), ObjectKind::Motion, [](const Motion& motion, SceneObject& out) {
            if (isUsable(motion.blockAt)) out.marks.push_back(motion.blockAt);
        });
        each(stage.loads, under(pointer, "loads"), ObjectKind::Load, [](const Load& load, SceneObject& out) {
            for (const auto& place : {load.at ? load.at : load.blockAt, load.point})
                if (place && isUsable(*place)) out.marks.push_back(*place);
            if (load.along && isUsable((*load.along)[0]) && isUsable((*load.along)[1]))
                out.lines.push_back({{(*load.along)[0], (*load.along)[1]}});
        });
        each(stage.initialVelocities, under(pointer, "initial_velocities"), ObjectKind::Velocity,
             [](const InitialVelocity& velocity, SceneObject& out) {
                 if (isUsable(velocity.blockAt)) out.marks.push_back(velocity.blockAt);
             });
    }

    const Scene& scene_;
    std::vector<SceneObject> found_;
};

}  // namespace

bool endsAtOpenings(ObjectKind kind) {
    return kind == ObjectKind::Joint || kind == ObjectKind::JointSet || kind == ObjectKind::Voronoi;
}

std::optional<Box> boxOf(const SceneObject& object) {
    std::vector<Point> points = object.marks;
    for (const ObjectLine& line : object.lines) points.insert(points.end(), line.points.begin(), line.points.end());
    points.insert(points.end(), object.area.begin(), object.area.end());
    std::erase_if(points, [](const Point& p) { return !p.allFinite(); });
    return points.empty() ? std::nullopt : std::optional(boxOf(points));
}

bool isInOpening(std::span<const SceneObject> objects, const Point& place) {
    return std::any_of(objects.begin(), objects.end(), [&](const SceneObject& object) {
        if (object.kind != ObjectKind::Tunnel || object.area.empty()) return false;
        const Box box = boxOf(object.area);
        return locate(object.area, place, 1e-6 * (box.max - box.min).norm()) == Side::Inside;
    });
}

std::vector<SceneObject> objectsOf(const Scene& scene) { return ObjectCollector(scene).collect(); }

std::vector<ObjectLine> tracesOfSet(const Scene& scene, const SceneJointSet& set) {
    const std::vector<Point>* region = regionOf(scene, set.region);
    const JointSet drawn = jointSetOf(set);
    if (!region || !isUsable(set.origin) || jointSetProblem(drawn)) return {};
    if (jointTraceEstimate(drawn, *region) > mostShownTraces) return {};
    std::vector<ObjectLine> lines;
    for (const JointTrace& trace : jointTraces(drawn, *region, toleranceIn(*region)))
        lines.push_back({{trace.segment.from, trace.segment.to}});
    return lines;
}

std::vector<ObjectLine> boltsOfPattern(const Scene& scene, const ScenePattern& pattern) {
    const int index = findTunnel(scene, pattern.tunnel);
    const BoltPattern laidOut = patternOf(pattern);
    if (index < 0 || boltPatternProblem(laidOut)) return {};
    const SceneTunnel& tunnel = scene.tunnels[index];
    if (!isUsable(tunnel.center) || !allUsable(tunnel.points) || profileProblem(shapeOf(tunnel))) return {};
    const TunnelProfile profile = tunnelProfile(shapeOf(tunnel));
    if (boltCount(profile, laidOut) > mostShownBolts) return {};
    std::vector<ObjectLine> lines;
    for (const PatternBolt& bolt : layOut(profile, laidOut)) lines.push_back({{bolt.head, bolt.farEnd}});
    return lines;
}

}  // namespace keyblock
