// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a scene from another source, such as an imported drawing, needs before it can
// be run: the same supports and stages that a drawn outline, tunnel and bolts get.
#pragma once

#include "ui/edit/edit.h"

namespace keyblock {

/// Adds supports to an outline without any, and stages to a scene without any: they settle the rock, excavate its
/// tunnels and install the bolts on their walls. Existing supports and stages are not changed.
Edit withRunSetup(const Scene& scene);

}  // namespace keyblock
