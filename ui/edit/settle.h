// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What every edit ends with, so that a scene in the window can always be written
// and is read back as the same: a file is refused where a field stands that does
// not apply, or where types of bolts are like one another in a circle.
#pragma once

#include "solver/scene/scene.h"

namespace keyblock {

/// Leaves out what does not apply (`increments` of a dynamic stage, say), and of types of bolts who they are like where
/// nobody is; their numbers stay. Drops built-in types that nothing names any more and adds those that something does.
void settle(Scene& scene);

}  // namespace keyblock
