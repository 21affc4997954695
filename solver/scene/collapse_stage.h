// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The dynamic stage that follows the motion of falling blocks after a static stage has
// ended in collapse, if that stage requests it by `on_collapse`.
#pragma once

#include "solver/scene/scene.h"

namespace keyblock {

/// Name of the dynamic stage that follows a collapse of `stage`, as shown in tables.
std::string nameOfCollapse(const Stage& stage);

/// The scene as it is run: each static stage with `on_collapse` set to `dynamic` is followed by a dynamic stage, which
/// runs only after a collapse. A scene that already has these stages is returned unchanged.
Scene withCollapseStages(Scene scene);

}  // namespace keyblock
