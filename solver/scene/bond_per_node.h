// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/scene/scene.h"

#include <algorithm>
#include <vector>

namespace keyblock {

/// Whether a range of anchors has a stiffness and strength per node. Such a bond is as strong as it has nodes, so the
/// divisions of its bolt are not a matter of accuracy.
inline bool isGivenPerNode(const std::vector<Anchor>& anchors) {
    return std::any_of(anchors.begin(), anchors.end(),
                       [](const Anchor& anchor) { return !anchor.at && anchor.per == Per::Node; });
}

}  // namespace keyblock
