// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/scene/shapes.h"

#include "geometry/cells/voronoi.h"
#include "geometry/polygon.h"
#include "solver/scene/suggest.h"

#include <algorithm>
#include <cassert>
#include <limits>

namespace keyblock {
namespace {

constexpr double usualTolerance = 1e-6;  // ratio to the longer side of the domain, as in the cut

template <typename Named>
int indexOfName(const std::vector<Named>& items, const std::string& name) {
    const auto found = std::find_if(items.begin(), items.end(), [&](const Named& item) { return item.name == name; });
    return found == items.end() ? -1 : static_cast<int>(found - items.begin());
}

const std::vector<Point>& regionOf(const Scene& scene, const std::optional<std::string>& name) {
    return name ? findRegion(scene, *name)->points : scene.domain->boundary;
}

double toleranceOf(const Scene& scene) {
    constexpr double least = 64.0 * std::numeric_limits<double>::epsilon();  // of a coordinate, as of the cut
    const Box box = boxOf(scene.domain->boundary);
    const double wanted = scene.cutting.tolerance.value_or(usualTolerance * (box.max - box.min).maxCoeff());
    return std::max(wanted, least * std::max(box.min.cwiseAbs().maxCoeff(), box.max.cwiseAbs().maxCoeff()));
}

/// Collects the traces of all sources, one source after another.
class Collector {
public:
    void begin(std::string text, int joint) { all.sources.push_back({std::move(text), joint}); }
    void add(const Point& from, const Point& to) {
        all.traces.push_back({from, to, static_cast<int>(all.sources.size()) - 1});
    }
    void addOutline(const std::vector<Point>& points) {
        for (std::size_t i = 0; i < points.size(); ++i) add(points[i], points[(i + 1) % points.size()]);
    }

    SceneTraces all;
};

void addVoronoi(const Scene& scene, Collector& out) {
    const SceneVoronoi& voronoi = *scene.voronoi;
    const std::vector<Point>& region = regionOf(scene, voronoi.region);
    out.begin("the Voronoi cells", jointOf(scene, voronoi.jointMaterial));
    const VoronoiCells cells =
        voronoiCells(region, voronoi.size, static_cast<std::uint64_t>(voronoi.seed), toleranceOf(scene));
    for (const Segment& edge : cells.edges) out.add(edge.from, edge.to);
    if (voronoi.region) out.addOutline(region);
}

}  // namespace

ProfileShape shapeOf(const SceneTunnel& tunnel) {
    switch (tunnel.profile) {
        case ProfileKind::Circle: return CircleShape{tunnel.center, tunnel.diameter};
        case ProfileKind::DShape: return DShape{tunnel.center, tunnel.width, tunnel.height};
        case ProfileKind::Horseshoe: return HorseshoeShape{tunnel.center, tunnel.width, tunnel.height};
        case ProfileKind::Arched: return ArchedShape{tunnel.center, tunnel.width, tunnel.wallHeight, tunnel.rise};
        case ProfileKind::Polygon: break;
    }
    return PolygonShape{tunnel.points};
}

JointSet jointSetOf(const SceneJointSet& set) {
    JointSet drawn;
    drawn.dip = set.dip;
    drawn.dipDeviation = set.dipDeviation;
    drawn.spacing = {set.spacing, set.spacingDeviation};
    if (set.traceLength) drawn.length = Scatter{*set.traceLength, set.traceLengthDeviation};
    drawn.bridge = {set.bridge, set.bridgeDeviation};
    drawn.stagger = set.stagger;
    drawn.origin = set.origin;
    drawn.seed = static_cast<std::uint64_t>(set.seed);
    return drawn;
}

BoltPattern patternOf(const ScenePattern& pattern) {
    return {pattern.from, pattern.to, pattern.way, pattern.spacing, pattern.offset, pattern.length,
            pattern.angleFromWall};
}

const SceneRegion* findRegion(const Scene& scene, const std::string& name) {
    const int index = indexOfName(scene.regions, name);
    return index < 0 ? nullptr : &scene.regions[index];
}

int findTunnel(const Scene& scene, const std::string& name) { return indexOfName(scene.tunnels, name); }

int jointOf(const Scene& scene, const std::optional<std::string>& name) {
    assert(scene.domain);
    const std::optional<std::string>& used = name ? name : scene.domain->jointMaterial;
    if (!used) return scene.jointMaterials.empty() ? builtInJoint : 0;
    const auto found = std::find_if(scene.jointMaterials.begin(), scene.jointMaterials.end(),
                                    [&](const auto& entry) { return entry.first == *used; });
    return found == scene.jointMaterials.end() ? builtInJoint : static_cast<int>(found - scene.jointMaterials.begin());
}

BoundarySide sideOf(const Point& from, const Point& to) {
    constexpr double slack = 1e-9;  // so that round-off does not change the side of an edge at 45°
    const Point outward = -turnLeft(to - from);
    if (std::abs(outward.y()) >= std::abs(outward.x()) * (1.0 - slack))
        return outward.y() > 0.0 ? BoundarySide::Top : BoundarySide::Bottom;
    return outward.x() > 0.0 ? BoundarySide::Right : BoundarySide::Left;
}

bool isOpenFromStart(const Scene& scene, const SceneTunnel& tunnel) {
    return std::none_of(scene.stages.begin(), scene.stages.end(), [&](const Stage& stage) {
        return std::find(stage.excavate.begin(), stage.excavate.end(), tunnel.name) != stage.excavate.end();
    });
}

bool standsInOpening(const Scene& scene, const std::vector<Point>& points) {
    assert(scene.domain);
    return std::any_of(scene.tunnels.begin(), scene.tunnels.end(), [&](const SceneTunnel& tunnel) {
        const ProfileShape shape = shapeOf(tunnel);
        if (!isOpenFromStart(scene, tunnel) || profileProblem(shape)) return false;
        return contains(outline(tunnelProfile(shape)), points, toleranceOf(scene));
    });
}

SceneTraces tracesOf(const Scene& scene) {
    assert(scene.domain);
    Collector out;
    for (const SceneJoint& joint : scene.joints) {
        out.begin("joint " + inQuotes(joint.name), jointOf(scene, joint.jointMaterial));
        for (std::size_t i = 0; i + 1 < joint.points.size(); ++i) out.add(joint.points[i], joint.points[i + 1]);
    }
    for (const SceneJointSet& set : scene.jointSets) {
        out.begin("joint set " + inQuotes(set.name), jointOf(scene, set.jointMaterial));
        for (const JointTrace& trace : jointTraces(jointSetOf(set), regionOf(scene, set.region), toleranceOf(scene)))
            out.add(trace.segment.from, trace.segment.to);
    }
    if (scene.voronoi) addVoronoi(scene, out);
    for (const SceneTunnel& tunnel : scene.tunnels) {
        out.begin("tunnel " + inQuotes(tunnel.name), intactJoint);
        out.addOutline(outline(tunnelProfile(shapeOf(tunnel))));
    }
    return std::move(out.all);
}

CutSettings cutSettings(const Scene& scene) {
    return {scene.cutting.tolerance, scene.cutting.minArea, scene.cutting.minWidth, false};
}

}  // namespace keyblock
