// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Converts the section of a scene into shapes of the geometry library. The check and
// the cut both use these functions, so that they always work on the same shapes.
#pragma once

#include "geometry/cut/cut.h"
#include "geometry/shape/bolt_pattern.h"
#include "geometry/shape/joint_set.h"
#include "geometry/shape/tunnel_profile.h"
#include "solver/scene/scene.h"

#include <string>
#include <vector>

namespace keyblock {

ProfileShape shapeOf(const SceneTunnel& tunnel);
JointSet jointSetOf(const SceneJointSet& set);
BoltPattern patternOf(const ScenePattern& pattern);

/// The region with this name; null if there is none.
const SceneRegion* findRegion(const Scene& scene, const std::string& name);

/// Index of the tunnel with this name; −1 if there is none.
int findTunnel(const Scene& scene, const std::string& name);

/// Index of a joint's material in `scene.jointMaterials`. A joint that names no material has that of the domain or, if
/// the domain names none, the first one of the scene. `builtInJoint` if this material does not exist.
/// \param name the joint material named by the joint, if any
/// \pre the scene has a domain.
int jointOf(const Scene& scene, const std::optional<std::string>& name);

/// Side of the domain on which an edge lies, from the direction of its outward normal. An edge at exactly 45° counts as
/// bottom or top.
/// \param from, to start and end of the edge, with the domain on its left
BoundarySide sideOf(const Point& from, const Point& to);

/// True if no stage excavates the tunnel.
bool isOpenFromStart(const Scene& scene, const SceneTunnel& tunnel);

/// True if the outline `points` lies entirely inside one tunnel for which `isOpenFromStart` is true.
/// \pre the scene has a domain, and the outline does not cross itself.
bool standsInOpening(const Scene& scene, const std::vector<Point>& points);

/// Origin of a trace. `CutTrace::source` is the index of the origin in `SceneTraces::sources`.
struct TraceSource {
    std::string text;  // name for messages: joint 'fault', tunnel 'drift', …
    int joint = builtInJoint;  // joint-material index of the faces
};

/// All traces that cut the domain, in the order of their sources: joints, joint sets, Voronoi cells, then tunnel
/// outlines.
struct SceneTraces {
    std::vector<CutTrace> traces;
    std::vector<TraceSource> sources;
};

/// \pre the scene has a domain, and its section has been checked and has no errors.
SceneTraces tracesOf(const Scene& scene);

/// Settings for `cutIntoBlocks`, taken from the scene's `cutting`.
CutSettings cutSettings(const Scene& scene);

}  // namespace keyblock
