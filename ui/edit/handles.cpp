// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/edit/handles.h"

#include "geometry/segment.h"
#include "solver/scene/lookup.h"
#include "solver/scene/pointer.h"
#include "solver/scene/shapes.h"
#include "ui/edit/locate.h"
#include "ui/edit/values.h"
#include "ui/edit/wall_at.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace keyblock {
namespace {

template <typename Item>
const Item* itemAt(const std::vector<Item>& items, const std::vector<std::string>& parts, const char* list) {
    if (parts.size() != 2 || parts[0] != list) return nullptr;
    const std::size_t index = std::atoll(parts[1].c_str());
    return index < items.size() ? &items[index] : nullptr;
}

/// The corners of an object, and whether the last corner is connected to the first.
struct Corners {
    std::string pointer;
    const std::vector<Point>* points = nullptr;
    bool closed = true;
};

Corners cornersOf(const Scene& scene, const std::string& pointer) {
    const std::vector<std::string> parts = partsOf(pointer);
    if (pointer == "/domain" && scene.domain) return {"/domain/boundary", &scene.domain->boundary};
    const std::string points = under(pointer, "points");
    if (const auto* joint = itemAt(scene.joints, parts, "joints")) return {points, &joint->points, false};
    if (const auto* block = itemAt(scene.blocks, parts, "blocks")) return {points, &block->points};
    if (const auto* region = itemAt(scene.regions, parts, "regions")) return {points, &region->points};
    const auto* tunnel = itemAt(scene.tunnels, parts, "tunnels");
    if (tunnel && tunnel->profile == ProfileKind::Polygon) return {points, &tunnel->points};
    return {};
}

void addTunnel(const SceneTunnel& tunnel, const std::string& pointer, std::vector<Handle>& out) {
    const Point& c = tunnel.center;
    const auto add = [&](const Point& place, const char* name, const char* key) {
        if (place.allFinite()) out.push_back({place, name, under(pointer, key), false});
    };
    add(c, "middle", "center");
    if (tunnel.profile == ProfileKind::Circle) {
        add(c + Point(0.5 * tunnel.diameter, 0.0), "diameter", "diameter");
        return;
    }
    const bool arched = tunnel.profile == ProfileKind::Arched;
    const double height = arched ? tunnel.wallHeight + tunnel.rise : tunnel.height;
    const Point floor = c - Point(0.0, 0.5 * height);
    add(floor + Point(0.5 * tunnel.width, arched ? tunnel.wallHeight : std::max(height - 0.5 * tunnel.width, 0.0)), "width",
        "width");
    if (arched) add(floor + Point(-0.5 * tunnel.width, tunnel.wallHeight), "wall height", "wall_height");
    add(floor + Point(0.0, height), arched ? "rise" : "height", arched ? "rise" : "height");
}

void addPlaces(const Scene& scene, const std::string& pointer, std::vector<Handle>& out) {
    const auto place = locate(scene, pointer);
    if (!place || !place->isObject() || !place->field) return;
    for (const Field& field : place->objectStructure().fields) {
        if (field.unit != "m" || !field.get) continue;
        const FieldValue value = field.get(place->object());
        const std::string at = under(pointer, field.key);
        std::string name(field.key);
        std::replace(name.begin(), name.end(), '_', ' ');
        if (const auto* point = std::get_if<Point>(&value)) out.push_back({*point, name, at, false});
        const auto* points = std::get_if<std::vector<Point>>(&value);
        for (std::size_t i = 0; points && i < points->size(); ++i)
            out.push_back({(*points)[i], i == 0 ? "beginning" : "end", under(at, i), false});
    }
}

/// Dimensions of a tunnel from the position of one handle.
Edit sized(const Scene& scene, const SceneTunnel& tunnel, const Handle& handle, const std::string& pointer,
           const Point& place) {
    constexpr double least = 0.01;  // [m]
    const Point off = place - tunnel.center;
    if (handle.name == "width") return setValueAt(scene, handle.pointer, std::max(least, 2.0 * std::abs(off.x())));
    if (handle.name == "diameter") return setValueAt(scene, handle.pointer, std::max(least, 2.0 * off.norm()));
    const bool arched = tunnel.profile == ProfileKind::Arched;
    const double height = arched ? tunnel.wallHeight + tunnel.rise : tunnel.height;
    const double floor = tunnel.center.y() - 0.5 * height;
    const double walls = handle.name == "rise" ? tunnel.wallHeight : 0.0;
    const double value = std::max(least, place.y() - floor - walls);
    const double whole = handle.name == "height" ? value : value + (handle.name == "rise" ? walls : tunnel.rise);
    Edit edit = setValueAt(scene, handle.pointer, value);
    if (!edit.done()) return edit;
    return setValueAt(edit.scene, under(pointer, "center"), Point(tunnel.center.x(), floor + 0.5 * whole));
}

/// A bolt keeps its length when its head slides along a wall.
Edit movedHead(const Scene& scene, const Bolt& bolt, const Handle& handle, const std::string& pointer, const Point& place,
               double reach) {
    const auto wall = wallAt(scene, place, reach);
    if (!wall) return setValueAt(scene, handle.pointer, place);
    Edit edit = setValueAt(scene, handle.pointer, wall->place);
    return edit.done() ? setValueAt(edit.scene, under(pointer, "far_end"), Point(wall->place + lengthOf(bolt) * wall->inward))
                       : edit;
}

}  // namespace

std::vector<Handle> handlesOf(const Scene& scene, const std::string& pointer) {
    std::vector<Handle> out;
    const std::vector<std::string> parts = partsOf(pointer);
    const Corners corners = cornersOf(scene, pointer);
    for (std::size_t i = 0; corners.points && i < corners.points->size(); ++i)
        out.push_back({(*corners.points)[i], "corner " + std::to_string(i + 1), under(corners.pointer, i), true});
    if (corners.points) return out;
    if (const auto* tunnel = itemAt(scene.tunnels, parts, "tunnels")) {
        addTunnel(*tunnel, pointer, out);
        return out;
    }
    addPlaces(scene, pointer, out);
    const auto* pattern = itemAt(scene.boltPatterns, parts, "bolt_patterns");
    const int tunnel = pattern ? findTunnel(scene, pattern->tunnel) : -1;
    for (Handle& handle : out)  // the ends of a pattern are on the wall
        if (const auto wall = wallOfTunnel(scene, tunnel, handle.place)) handle.place = wall->place;
    std::erase_if(out, [](const Handle& handle) { return !isUsable(handle.place); });
    return out;
}

Edit dragHandle(const Scene& scene, const std::string& pointer, std::size_t index, const Point& place, double reach) {
    const std::vector<Handle> handles = handlesOf(scene, pointer);
    if (index >= handles.size() || !isUsable(place)) return {scene, "There is no such point."};
    const Handle& handle = handles[index];
    const std::vector<std::string> parts = partsOf(pointer);
    const auto* tunnel = itemAt(scene.tunnels, parts, "tunnels");
    if (tunnel && !handle.isCorner && handle.name != "middle") return sized(scene, *tunnel, handle, pointer, place);
    const auto* bolt = itemAt(scene.bolts, parts, "bolts");
    if (bolt && handle.pointer.ends_with("/head")) return movedHead(scene, *bolt, handle, pointer, place, reach);
    if (const auto* pattern = itemAt(scene.boltPatterns, parts, "bolt_patterns"))
        if (const auto wall = wallOfTunnel(scene, findTunnel(scene, pattern->tunnel), place))
            return setValueAt(scene, handle.pointer, wall->place);
    return setValueAt(scene, handle.pointer, place);
}

Edit withCorner(const Scene& scene, const std::string& pointer, const Point& place) {
    const Corners corners = cornersOf(scene, pointer);
    if (!corners.points || corners.points->size() < 2 || !isUsable(place)) return {scene, "The object has no corners."};
    const std::vector<Point>& points = *corners.points;
    double nearest = std::numeric_limits<double>::infinity();
    std::size_t behind = 0;
    Point corner = place;
    const std::size_t edges = corners.closed ? points.size() : points.size() - 1;
    for (std::size_t i = 0; i < edges; ++i) {
        const Point &a = points[i], &b = points[(i + 1) % points.size()];
        const double distance = distanceToSegment(a, b, place);
        if (!(distance < nearest)) continue;
        nearest = distance, behind = i;
        corner = a + std::clamp(footParameter(a, b, place), 0.0, 1.0) * (b - a);
    }
    std::vector<Point> more = points;
    more.insert(more.begin() + static_cast<std::ptrdiff_t>(behind) + 1, corner);
    Edit edit = setValueAt(scene, corners.pointer, more);
    if (edit.done()) edit.made = under(corners.pointer, behind + 1);
    return edit;
}

}  // namespace keyblock
