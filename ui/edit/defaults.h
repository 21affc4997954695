// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Default values of new objects, typical of hard jointed rock, and the stages that an
// engineer expects. They only make a new object usable at once and should be replaced
// by values measured for the rock.
#pragma once

#include "solver/scene/field.h"
#include "ui/edit/edit.h"

#include <string>
#include <vector>

namespace keyblock {

/// A scene to start from: a granite material, a joint material with 30° friction, gravity, and the stages `settle` and
/// `excavate`, but no rock yet.
Scene newScene();

/// Sets the required fields of a new object to usable values. \param made a default-constructed struct described by
/// `structure`.
void makeDefaults(const Scene& scene, const Structure& structure, void* made);

/// The reason why the corners do not form a valid outline; empty if they do.
std::string outlineProblem(const std::vector<Point>& points);

/// Sets the outline of the rock. If the scene has no supports, adds the default ones with `supportSides`. Refused if
/// the outline is not valid (see `outlineProblem`).
Edit withDomain(const Scene& scene, const std::vector<Point>& boundary);

/// Adds a fixed support at the base of the outline and roller supports at its sides, so that the sides can move only
/// vertically.
/// \pre the scene has an outline and no supports.
void supportSides(Edit& edit);

/// Installs a bolt in a stage after the excavation of its tunnel, as described for `withPattern`. Its tunnel is the one
/// in which the head of the bolt lies (inside or on the wall). Does nothing if there is no such tunnel, or if no stage
/// excavates it.
void installOnWall(Edit& edit, const Bolt& bolt);

/// Adds a tunnel. It is excavated in the last stage that already excavates something or, if there is none, in the first
/// stage with "excavat" in its name. If there is no such stage either, the tunnel is open from the start.
Edit withTunnel(const Scene& scene, const SceneTunnel& tunnel);

/// Adds a bolt pattern or a bolt. If a stage excavates the tunnel to which it belongs, the new bolts are installed in
/// the first later stage that installs bolts. If there is no such stage, a new stage is inserted after the excavation.
/// Half of the wall relaxation is then moved to the new stage, because bolts installed after all movement carry no
/// load. The relaxation is not changed if the excavation stage is dynamic or already specifies it.
Edit withPattern(const Scene& scene, const ScenePattern& pattern);
Edit withBolt(const Scene& scene, const Bolt& bolt);

/// Sets the kind of a stage. A dynamic stage without a duration gets a default duration.
Edit withStageKind(const Scene& scene, std::size_t stage, StageKind kind);

/// Name of the first rock material or joint material of the scene; empty if there is none.
std::string firstMaterial(const Scene& scene);
std::string firstJointMaterial(const Scene& scene);

}  // namespace keyblock
