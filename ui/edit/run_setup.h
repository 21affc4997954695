// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Completes a scene from another source, such as an imported drawing, so that it can be
// run: it gets the same supports and stages as a scene drawn by hand.
#pragma once

#include "ui/edit/edit.h"

namespace keyblock {

/// Adds supports if the scene has an outline but no supports, and stages if it has rock but no stages: the stages
/// settle the rock, excavate the tunnels and install the bolts on their walls. Existing supports and stages are not
/// changed.
Edit withRunSetup(const Scene& scene);

}  // namespace keyblock
