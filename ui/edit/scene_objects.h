// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Everything of a scene that a person can point at, with the shape that it has on
// the section. What is drawn by a few numbers (sets, cells, patterns) has the lines
// that the cut will draw; where these are too many or cannot be drawn, a sign at
// its place stands for it.
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
    bool curved = false;  // stands for an arc: its inner points are no corners
};

struct SceneObject {
    std::string pointer;  // JSON pointer
    ObjectKind kind = ObjectKind::Joint;
    std::string title;  // for people: `joint J12`
    std::vector<ObjectLine> lines;
    std::vector<Point> marks;  // places without extent [m]
    std::vector<Point> middles;  // of shapes drawn round a middle [m]
    std::vector<Point> area;  // outline of what belongs to it [m]; empty: only lines and marks do
};

/// True for what lies in rock and is not seen where an opening has taken the rock away.
bool endsAtOpenings(ObjectKind kind);

/// Round all that has a place; none: nothing has [m].
std::optional<Box> boxOf(const SceneObject& object);

/// True when the place lies in one of the tunnels among the objects, and not on its wall.
bool isInOpening(std::span<const SceneObject> objects, const Point& place);

/// In the order of the scene's parts. Bears any scene; what has no usable place is left out.
std::vector<SceneObject> objectsOf(const Scene& scene);

/// The traces of one set in the region that it names, as `objectsOf` shows them: for a preview. Empty where it cannot be
/// drawn, or would give more than `mostShownTraces`.
std::vector<ObjectLine> tracesOfSet(const Scene& scene, const SceneJointSet& set);

inline constexpr double mostShownTraces = 10000.0;  // as the check allows

/// A bolt of a pattern each, head first; empty where it cannot be laid out.
std::vector<ObjectLine> boltsOfPattern(const Scene& scene, const ScenePattern& pattern);

}  // namespace keyblock
