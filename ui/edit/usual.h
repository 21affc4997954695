// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a new thing begins with: usual numbers of hard jointed rock, and the stages
// that an engineer expects. Nothing here is better than what a person knows of
// their rock; it only makes that a new thing can be looked at and run at once.
#pragma once

#include "solver/scene/field.h"
#include "ui/edit/edit.h"

#include <string>
#include <vector>

namespace keyblock {

/// A scene to begin drawing in: granite, a joint of 30°, gravity, stages that settle and excavate; no rock yet.
Scene newScene();

/// Gives a default-made struct of that structure what a file would have to say.
void makeUsual(const Scene& scene, const Structure& structure, void* made);

/// What keeps corners from being the outline of something; empty when nothing does.
std::string outlineProblem(const std::vector<Point>& points);

/// The outline of the rock. Where nothing holds the scene yet, its bottom is held and its sides move only downward.
/// Refused: an outline without area, or one that crosses itself.
Edit withDomain(const Scene& scene, const std::vector<Point>& boundary);

/// Fixes the bottom of the outline and lets its sides move only vertically. \pre the scene has an outline, no supports.
void supportSides(Edit& edit);

/// Installs a bolt of the scene, whose head is on the wall of a tunnel that a stage excavates, after that stage.
void installOnWall(Edit& edit, const Bolt& bolt);

/// A tunnel, taken out by the last stage that excavates something or is called so; open from the start without one.
Edit withTunnel(const Scene& scene, const SceneTunnel& tunnel);

/// A pattern or a bolt. Where a stage excavates its tunnel and none after it installs bolts, a stage that does is put
/// behind, and the walls are let go half before it and half in it: bolts that came after all movement would hold nothing.
Edit withPattern(const Scene& scene, const ScenePattern& pattern);
Edit withBolt(const Scene& scene, const Bolt& bolt);

/// The kind of a stage; a dynamic one that has no duration yet gets a usual one.
Edit withStageKind(const Scene& scene, std::size_t stage, StageKind kind);

/// The first entry's name of these lists; empty without any.
std::string firstMaterial(const Scene& scene);
std::string firstJointMaterial(const Scene& scene);

}  // namespace keyblock
