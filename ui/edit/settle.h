// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Applied at the end of every edit, so that a scene in the window can always be written
// and read back unchanged. The file reader refuses fields that do not apply, and bolt
// types that are derived from each other in a circle.
#pragma once

#include "solver/scene/scene.h"

namespace keyblock {

/// Resets fields that do not apply, such as `increments` of a dynamic stage, to their defaults. Clears `like` of bolt
/// types whose base type cannot be resolved; their values are kept. Removes built-in bolt types that are not used, and
/// adds built-in bolt types that are used but missing.
void settle(Scene& scene);

}  // namespace keyblock
