// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Adds objects drawn with the tools to a scene, under names that are not yet used.
// Invalid objects are refused, with the reason.
#pragma once

#include "ui/edit/edit.h"

namespace keyblock {

Edit withBlock(const Scene& scene, const Block& block);
Edit withRegion(const Scene& scene, const SceneRegion& region);
Edit withJoint(const Scene& scene, const SceneJoint& joint);
Edit withJointSet(const Scene& scene, const SceneJointSet& set);
Edit withMonitor(const Scene& scene, const Monitor& monitor);

/// Adds a support. A support on a side of the domain replaces an existing support on that side.
Edit withSupport(const Scene& scene, const Support& support);

/// Adds a load or a prescribed motion to the stage with this index.
Edit withLoad(const Scene& scene, std::size_t stage, const Load& load);
Edit withMotion(const Scene& scene, std::size_t stage, const Motion& motion);

}  // namespace keyblock
