// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Defaults of new objects: typical values of hard jointed rock, and the stages that
// an engineer expects. They only make a new object usable at once; measured values
// of the rock should replace them.
#pragma once

#include "solver/scene/field.h"
#include "ui/edit/edit.h"

#include <string>
#include <vector>

namespace keyblock {

/// An initial scene: granite, a joint material of 30°, gravity, stages `settle` and `excavate`; no rock yet.
Scene newScene();

/// Fills the required fields of a default-constructed struct of that structure.
void makeDefaults(const Scene& scene, const Structure& structure, void* made);

/// Why the corners are not a valid outline; empty if they are.
std::string outlineProblem(const std::vector<Point>& points);

/// Sets the outline of the rock. If the scene has no supports, its bottom is fixed and its sides move only vertically.
/// Refused: an outline without area, or one that crosses itself.
Edit withDomain(const Scene& scene, const std::vector<Point>& boundary);

/// Fixes the bottom of the outline and lets its sides move only vertically. \pre the scene has an outline, no supports.
void supportSides(Edit& edit);

/// Installs a bolt whose head is on the wall of a tunnel after the stage that excavates the tunnel.
void installOnWall(Edit& edit, const Bolt& bolt);

/// Adds a tunnel. The last stage that excavates, by content or by name, excavates it; else it is open from the start.
Edit withTunnel(const Scene& scene, const SceneTunnel& tunnel);

/// Adds a pattern or a bolt. If a stage excavates its tunnel and no later one installs bolts, a stage for them is
/// inserted after it, and half of the relaxation is moved there: bolts installed after all movement carry no load.
Edit withPattern(const Scene& scene, const ScenePattern& pattern);
Edit withBolt(const Scene& scene, const Bolt& bolt);

/// Sets the kind of a stage; a dynamic stage without a duration gets a default.
Edit withStageKind(const Scene& scene, std::size_t stage, StageKind kind);

/// The name of the first entry of these lists; empty if there is none.
std::string firstMaterial(const Scene& scene);
std::string firstJointMaterial(const Scene& scene);

}  // namespace keyblock
