// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Applied at the end of every edit so that a scene in the window can always be
// written and read back unchanged: a file is refused if a field does not apply, or
// if bolt types are derived from each other in a circle.
#pragma once

#include "solver/scene/scene.h"

namespace keyblock {

/// Resets fields that do not apply (`increments` of a dynamic stage, for example), and clears `like` of bolt types that
/// cannot be resolved; their values stay. Removes unused built-in types and adds those that are used.
void settle(Scene& scene);

}  // namespace keyblock
