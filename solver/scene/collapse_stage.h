// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The dynamic stage in which falling blocks are followed after a static stage has
// ended as a collapse, where that stage requests it by `on_collapse`.
#pragma once

#include "solver/scene/scene.h"

namespace keyblock {

/// Its name in tables.
std::string nameOfCollapse(const Stage& stage);

/// The scene as it is run: each static stage that requests it is followed by a dynamic one, which runs only after a
/// collapse. A scene that has them already comes back as it is.
Scene withCollapseStages(Scene scene);

}  // namespace keyblock
