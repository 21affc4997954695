// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A block has a single outline without holes. If the cut leaves a block with an
// opening in it, two additional cuts split the block: from the opening to the
// nearest outlines on its left and on its right. The faces of these cuts are
// intact rock (theory, "Cut scenes").
#include "solver/scene/scene_cut.h"

#include "geometry/polygon.h"
#include "solver/scene/lookup.h"
#include "solver/scene/number_text.h"
#include "solver/scene/shapes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace keyblock {
namespace {

std::vector<Point> pointsOf(const Cut& cut, const CutRing& ring) {
    std::vector<Point> points;
    for (int vertex : ring.vertices) points.push_back(cut.vertices[vertex]);
    return points;
}

using Rings = std::vector<std::vector<Point>>;

Rings ringsOf(const Cut& cut, const CutBlock& block) {
    Rings rings{pointsOf(cut, block.outer)};
    for (const CutRing& hole : block.holes) rings.push_back(pointsOf(cut, hole));
    return rings;
}

/// The x coordinates, in increasing order, at which the horizontal line through y crosses the edges of the rings [m].
std::vector<double> crossingsAt(const Rings& rings, double y) {
    std::vector<double> places;
    for (const std::vector<Point>& ring : rings)
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Point &a = ring[i], &b = ring[(i + 1) % ring.size()];
            if ((a.y() > y) == (b.y() > y)) continue;
            places.push_back(a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
        }
    std::sort(places.begin(), places.end());
    return places;
}

/// A point well inside. It lies on a horizontal line, half-way between the two successive corner heights that are
/// farthest apart, in the middle of the widest part of this line.
Point placeInside(const Rings& rings) {
    std::vector<double> heights;
    for (const std::vector<Point>& ring : rings)
        for (const Point& p : ring) heights.push_back(p.y());
    std::sort(heights.begin(), heights.end());
    double y = heights.front(), gap = -1.0;
    for (std::size_t i = 0; i + 1 < heights.size(); ++i)
        if (heights[i + 1] - heights[i] > gap) gap = heights[i + 1] - heights[i], y = heights[i] + 0.5 * gap;
    const std::vector<double> places = crossingsAt(rings, y);
    double x = 0.0, width = -1.0;
    for (std::size_t i = 0; i + 1 < places.size(); i += 2)
        if (places[i + 1] - places[i] > width) width = places[i + 1] - places[i], x = places[i] + 0.5 * width;
    return {x, y};
}

/// Gradient of the splits: horizontal ones would coincide with horizontal bolts at the springing line of a tunnel.
constexpr double fall = 0.137;

/// The nearest point of the other rings (all but ring `but`) on a line that falls from `from` to the left (way −1) or
/// to the right (way 1).
Point acrossFrom(const Rings& rings, std::size_t but, const Point& from, double way) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t r = 0; r < rings.size(); ++r) {
        if (r == but) continue;
        for (std::size_t i = 0; i < rings[r].size(); ++i) {
            const auto sheared = [&](const Point& p) { return Point(p.x(), p.y() + way * fall * (p.x() - from.x())); };
            const Point a = sheared(rings[r][i]), b = sheared(rings[r][(i + 1) % rings[r].size()]);
            if (std::max(a.y(), b.y()) < from.y() || std::min(a.y(), b.y()) > from.y()) continue;
            const double rise = b.y() - a.y();
            const double x = rise == 0.0 ? (way * a.x() < way * b.x() ? a.x() : b.x())
                                         : a.x() + (from.y() - a.y()) / rise * (b.x() - a.x());
            if (way * (x - from.x()) >= 0.0) nearest = std::min(nearest, way * (x - from.x()));
        }
    }
    return {from.x() + way * nearest, from.y() - fall * nearest};
}

/// Adds two cuts for each opening of a block, from its leftmost and its rightmost corner. If there are several of
/// these, the lowest is used.
void addSplits(const Cut& cut, const CutBlock& block, int source, std::vector<CutTrace>& traces) {
    const Rings rings = ringsOf(cut, block);
    for (std::size_t hole = 1; hole < rings.size(); ++hole)
        for (double way : {-1.0, 1.0}) {
            const Point corner = *std::max_element(rings[hole].begin(), rings[hole].end(), [&](auto& a, auto& b) {
                return std::pair(way * a.x(), -a.y()) < std::pair(way * b.x(), -b.y());
            });
            const Point end = acrossFrom(rings, hole, corner, way);
            if (end.allFinite() && end != corner) traces.push_back({corner, end, source});
        }
}

/// Builds the blocks of the scene from the blocks of the cut.
class Builder {
public:
    Builder(const Scene& scene, const Cut& cut, const SceneTraces& traces, SceneCut& result)
        : scene_(scene), cut_(cut), traces_(traces), result_(result) {
        for (const SceneTunnel& tunnel : scene.tunnels) outlines_.push_back(outline(tunnelProfile(shapeOf(tunnel))));
    }

    void add(const CutBlock& block) {
        const std::vector<int> tunnels = tunnelsOf(block);
        if (std::any_of(tunnels.begin(), tunnels.end(), [&](int t) { return isOpen(t); })) {
            ++result_.open;
            return;
        }
        Block& made = result_.scene.blocks.emplace_back();
        made.points = pointsOf(cut_, block.outer);
        made.material = scene_.domain->material;
        made.jointMaterial = scene_.domain->jointMaterial;
        made.tunnels = tunnels;
        for (std::size_t e = 0; e < block.outer.sources.size(); ++e)
            made.faces.push_back(faceOn(block.outer.sources[e], made.points[e],
                                        made.points[(e + 1) % made.points.size()]));
        used_.insert(block.outer.vertices.begin(), block.outer.vertices.end());
        ++result_.blocks;
        result_.edges += static_cast<int>(made.points.size());
        result_.area += block.area;
        result_.vertices = static_cast<int>(used_.size());
    }

private:
    bool isOpen(int tunnel) const { return isOpenFromStart(scene_, scene_.tunnels[tunnel]); }

    /// The tunnels in which the block lies. There can be several if outlines overlap, for example those of a pilot and
    /// of the drift to which it is enlarged.
    std::vector<int> tunnelsOf(const CutBlock& block) const {
        if (outlines_.empty()) return {};
        const Point inside = placeInside(ringsOf(cut_, block));
        std::vector<int> found;
        for (std::size_t t = 0; t < outlines_.size(); ++t)
            if (locate(outlines_[t], inside, 0.0) != Side::Outside) found.push_back(static_cast<int>(t));
        return found;
    }

    CutFace faceOn(int source, const Point& from, const Point& to) const {
        CutFace face;
        if (source == borderSource) {
            face.joint = jointOf(scene_, {});
            face.side = sideOf(from, to);
            return face;
        }
        face.joint = traces_.sources[source].joint;
        if (source < static_cast<int>(scene_.joints.size() + scene_.jointSets.size())) face.source = source;
        return face;
    }

    const Scene& scene_;
    const Cut& cut_;
    const SceneTraces& traces_;
    SceneCut& result_;
    std::vector<std::vector<Point>> outlines_;
    std::set<int> used_;
};

/// Cuts until no block has an opening. One round of splits is normally enough; rounding in the cut can make further
/// rounds necessary.
Cut cutWithoutOpenings(const Scene& scene, SceneTraces& traces, int& splits, const std::atomic<bool>* stop) {
    constexpr int mostRounds = 8;
    const std::vector<CutDomain> domains{{0, scene.domain->boundary}};
    const int source = static_cast<int>(traces.sources.size());
    Cut cut = cutIntoBlocks(domains, traces.traces, cutSettings(scene));
    traces.sources.push_back({"intact rock", intactJoint});
    const std::vector<CutNote> notes = cut.notes;  // notes on the geometry of the scene, not on the splits
    for (int round = 0; round < mostRounds && !(stop && *stop); ++round) {
        const std::size_t before = traces.traces.size();
        for (const CutBlock& block : cut.blocks) addSplits(cut, block, source, traces.traces);
        if (traces.traces.size() == before) break;
        splits += static_cast<int>(traces.traces.size() - before);
        cut = cutIntoBlocks(domains, traces.traces, cutSettings(scene));
    }
    cut.notes = notes;
    return cut;
}

/// Finds the source of the joint of each dilation. The joints and their names are removed by the cut, but each face
/// keeps its source.
void findDilated(const Scene& scene, std::vector<Stage>& stages) {
    for (Stage& stage : stages)
        for (Dilation& dilation : stage.dilations) dilation.source = traceSource(scene, dilation.joint);
}

void cutDomain(const Scene& scene, SceneCut& result, const std::atomic<bool>* stop) {
    SceneTraces traces = tracesOf(scene);
    const Cut cut = cutWithoutOpenings(scene, traces, result.split, stop);
    if (stop && *stop) return;
    Builder builder(scene, cut, traces, result);
    for (const CutBlock& block : cut.blocks) builder.add(block);
    result.notes = cut.notes;
    result.tolerance = cut.tolerance, result.minArea = cut.minArea, result.minWidth = cut.minWidth;
    for (TraceSource& source : traces.sources) result.sources.push_back(std::move(source.text));
    findDilated(scene, result.scene.stages);
    result.scene.domain.reset();
    result.scene.joints.clear();
    result.scene.jointSets.clear();
    result.scene.voronoi.reset();
}

void layOutPattern(const Scene& scene, int index, std::vector<Bolt>& bolts) {
    const ScenePattern& pattern = scene.boltPatterns[index];
    const SceneTunnel& tunnel = scene.tunnels[findTunnel(scene, pattern.tunnel)];
    int number = 0;
    for (const PatternBolt& laid : layOut(tunnelProfile(shapeOf(tunnel)), patternOf(pattern))) {
        Bolt& bolt = bolts.emplace_back();
        bolt.name = pattern.name + "." + std::to_string(++number);
        bolt.type = pattern.type;
        bolt.farEnd = laid.farEnd;
        bolt.head = laid.head;
        bolt.divisions = pattern.divisions;
        bolt.plate = pattern.plate;
        bolt.spacingOutOfPlane = pattern.spacingOutOfPlane;
        bolt.pretension = pattern.pretension;
        bolt.pattern = index;
    }
}

bool isLaidOut(const Scene& scene) {
    return std::any_of(scene.bolts.begin(), scene.bolts.end(), [](const Bolt& bolt) { return bolt.pattern >= 0; });
}

}  // namespace

bool needsCut(const Scene& scene) {
    return scene.domain.has_value() || (!scene.boltPatterns.empty() && !isLaidOut(scene));
}

SceneCut cutScene(const Scene& scene, const std::atomic<bool>* stop) {
    SceneCut result;
    result.scene = scene;
    if (scene.domain) {
        for (Block& block : result.scene.blocks)
            block.inOpening = standsInOpening(scene, block.points);
        cutDomain(scene, result, stop);
    }
    for (std::size_t i = 0; i < scene.boltPatterns.size() && !isLaidOut(scene); ++i)
        layOutPattern(scene, static_cast<int>(i), result.scene.bolts);
    return result;
}

std::string_view wordOf(CutNoteKind kind) {
    switch (kind) {
        case CutNoteKind::MergedTrace: return "merged trace";
        case CutNoteKind::MovedEnd: return "moved end";
        case CutNoteKind::PulledEnd: return "pulled end";
        case CutNoteKind::TrimmedEnd: return "trimmed end";
        case CutNoteKind::TrimmedStretch: return "trimmed stretch";
        case CutNoteKind::DroppedShort: return "dropped short trace";
        case CutNoteKind::DroppedOutside: return "dropped outside trace";
        case CutNoteKind::DroppedLoose: return "dropped loose trace";
        case CutNoteKind::DroppedNotFinite: return "dropped trace that is not finite";
        case CutNoteKind::DroppedDomain: return "dropped domain";
        case CutNoteKind::MergedSliver: return "merged sliver";
        case CutNoteKind::MergedUnsound: return "merged unsound block";
        case CutNoteKind::KeptSliver: return "kept sliver";
    }
    return "";
}

std::string noteText(const SceneCut& cut, const CutNote& note) {
    const auto name = [&](int source) {
        return source >= 0 && static_cast<std::size_t>(source) < cut.sources.size()
                   ? cut.sources[source] : std::string("the boundary");
    };
    const std::string length = lengthText(note.measure), area = areaText(note.measure);
    switch (note.kind) {
        case CutNoteKind::MergedTrace:
            return length + " of " + name(note.source) + " coincide with " + name(note.other) + ", which forms the faces";
        case CutNoteKind::MovedEnd:
            return "an end of " + name(note.source) + " was moved by " + length + " to meet a corner";
        case CutNoteKind::PulledEnd:
            return "an end of " + name(note.source) + " was extended by " + length + " to meet " + name(note.other);
        case CutNoteKind::TrimmedEnd:
            return "the last " + length + " of " + name(note.source) + " end in rock and do not bound a block";
        case CutNoteKind::TrimmedStretch: return length + " of " + name(note.source) + " do not bound a block";
        case CutNoteKind::DroppedShort:
            return "a trace of " + name(note.source) + ", " + length + " long, is shorter than the tolerance";
        case CutNoteKind::DroppedOutside:
            return "a trace of " + name(note.source) + ", " + length + " long, lies outside the domain";
        case CutNoteKind::DroppedLoose:
            return "a trace of " + name(note.source) + ", " + length + " long, does not bound a block";
        case CutNoteKind::DroppedNotFinite: return "a trace of " + name(note.source) + " is not finite";
        case CutNoteKind::DroppedDomain: return "the domain has no area";
        case CutNoteKind::MergedSliver:
            return "a block of " + area + " is below a limit and was merged with its neighbour across " + name(note.source);
        case CutNoteKind::MergedUnsound:
            return "a block of " + area + " would cross itself and was merged with its neighbour across " +
                   name(note.source);
        case CutNoteKind::KeptSliver: return "a block of " + area + " is below a limit but has no neighbour";
    }
    return "";
}

}  // namespace keyblock
