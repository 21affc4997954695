// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a scene from elsewhere, an imported drawing for example, needs before it can
// be run: supports and stages, the same as a drawn outline, tunnel and bolts get.
#pragma once

#include "ui/edit/edit.h"

namespace keyblock {

/// Adds supports to an outline without any, and stages to a scene without any: they settle the rock, excavate its
/// tunnels and install the bolts on their walls. What the scene has already stays as it is.
Edit withRunSetup(const Scene& scene);

}  // namespace keyblock
