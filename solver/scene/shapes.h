// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a scene says of its section in the words of geometry: the one place where
// the document's fields become the shapes that are drawn, so that the check judges
// what the cut will draw.
#pragma once

#include "geometry/bolt_pattern.h"
#include "geometry/cut.h"
#include "geometry/joint_set.h"
#include "geometry/tunnel_profile.h"
#include "solver/scene/scene.h"

#include <string>
#include <vector>

namespace keyblock {

ProfileShape shapeOf(const SceneTunnel& tunnel);
JointSet jointSetOf(const SceneJointSet& set);
BoltPattern patternOf(const ScenePattern& pattern);

/// The region of that name; null when there is none.
const SceneRegion* findRegion(const Scene& scene, const std::string& name);

/// Index of the tunnel of that name; −1 when there is none.
int findTunnel(const Scene& scene, const std::string& name);

/// Index of the joint material that a joint names, else of the domain's, else the first; `builtInJoint` without any.
/// \pre the scene has a domain.
int jointOf(const Scene& scene, const std::optional<std::string>& name);

/// The side of the domain that an edge lies on, run counter-clockwise: the one that its outward normal points to, at 45°
/// bottom or top.
BoundarySide sideOf(const Point& from, const Point& to);

/// True for a tunnel that no stage excavates.
bool isOpenFromStart(const Scene& scene, const SceneTunnel& tunnel);

/// True for an outline that lies wholly in such a tunnel, where there is no rock. \pre the scene has a domain,
/// and `points` do not cross themselves.
bool standsInOpening(const Scene& scene, const std::vector<Point>& points);

/// Where traces come from, by their source.
struct TraceSource {
    std::string text;  // for people: joint 'fault', tunnel 'drift', …
    int joint = builtInJoint;  // of the faces
};

/// All that cuts the domain: joints, joint sets, Voronoi cells, then outlines of tunnels, with rising sources.
struct SceneTraces {
    std::vector<CutTrace> traces;
    std::vector<TraceSource> sources;
};

/// \pre the scene has a domain and its section was checked without errors.
SceneTraces tracesOf(const Scene& scene);

/// What the cut takes for the scene's `cutting`.
CutSettings cutSettings(const Scene& scene);

}  // namespace keyblock
