// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// All objects of a scene that can be picked, with their shape on the section.
// Parametric objects (sets, cells, patterns) have the lines that the cut will draw;
// if these are too many or cannot be drawn, a symbol represents them.
#pragma once

#include "geometry/polygon.h"
#include "solver/scene/scene.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace keyblock {

enum class ObjectKind {
    Domain, Region, Joint, JointSet, Voronoi, Tunnel, Block, Support, Bolt, Pattern, Load, Motion, Velocity, Monitor
};

/// A line from point to point.
struct ObjectLine {
    std::vector<Point> points;  // [m]
    bool closed = false;  // the last joins the first
    bool curved = false;  // approximates an arc: its inner points are not corners
};

struct SceneObject {
    std::string pointer;  // JSON pointer
    ObjectKind kind = ObjectKind::Joint;
    std::string title;  // shown to the user: `joint J12`
    std::vector<ObjectLine> lines;
    std::vector<Point> marks;  // isolated points [m]
    std::vector<Point> middles;  // centres of shapes [m]
    std::vector<Point> area;  // outline of its area [m]; empty: it has only lines and marks
};

/// True for objects inside rock, which are not visible in openings.
bool endsAtOpenings(ObjectKind kind);

/// Bounding box of all points; none: there are none [m].
std::optional<Box> boxOf(const SceneObject& object);

/// True if the point is inside one of the tunnels among the objects, not on its wall.
bool isInOpening(std::span<const SceneObject> objects, const Point& place);

/// In the order of the scene's parts. Accepts any scene; objects without usable points are left out.
std::vector<SceneObject> objectsOf(const Scene& scene);

/// The traces of one set in the region that it names, as `objectsOf` shows them, for a preview. Empty if it cannot be
/// drawn, or would give more than `mostShownTraces`.
std::vector<ObjectLine> tracesOfSet(const Scene& scene, const SceneJointSet& set);

inline constexpr double mostShownTraces = 10000.0;  // as the check allows

/// The bolts of a pattern, head first; empty if it cannot be laid out.
std::vector<ObjectLine> boltsOfPattern(const Scene& scene, const ScenePattern& pattern);

}  // namespace keyblock
