// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// All objects of a scene that can be picked, with their shape on the section.
// Parametric objects (joint sets, Voronoi cells, bolt patterns) are represented by the
// lines they generate; if these are too many or cannot be generated, by a symbol.
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

/// A polyline.
struct ObjectLine {
    std::vector<Point> points;  // [m]
    bool closed = false;  // the last point is joined to the first
    bool curved = false;  // approximates an arc, so its inner points are not corners
};

struct SceneObject {
    std::string pointer;  // JSON pointer
    ObjectKind kind = ObjectKind::Joint;
    std::string title;  // shown to the user: `joint J12`
    std::vector<ObjectLine> lines;
    std::vector<Point> marks;  // isolated points [m]
    std::vector<Point> middles;  // centres of shapes, for snapping [m]
    std::vector<Point> area;  // outline of its interior [m]; empty: it has only lines and marks
};

/// True for kinds of objects that exist only in rock, so that they are not visible in openings.
bool endsAtOpenings(ObjectKind kind);

/// Bounding box of all points of the object [m]; null if it has no points.
std::optional<Box> boxOf(const SceneObject& object);

/// True if the point lies inside one of the tunnels among the objects; false if it lies on a wall.
bool isInOpening(std::span<const SceneObject> objects, const Point& place);

/// All objects, in the order in which they occur in the scene. Accepts any scene, even an invalid one; objects without
/// usable points are omitted.
std::vector<SceneObject> objectsOf(const Scene& scene);

/// The traces of a joint set within its region, for a preview. Gives the same traces as `objectsOf`. Empty if the
/// traces cannot be generated, or if there would be more than `mostShownTraces`.
std::vector<ObjectLine> tracesOfSet(const Scene& scene, const SceneJointSet& set);

inline constexpr double mostShownTraces = 10000.0;  // same limit as in the check

/// The bolts of a pattern, each from its head to its far end; empty if the pattern cannot be laid out.
std::vector<ObjectLine> boltsOfPattern(const Scene& scene, const ScenePattern& pattern);

}  // namespace keyblock
