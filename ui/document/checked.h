// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Checks, cuts and draws a scene: what the document does in the background with
// each scene that it comes to hold.
#pragma once

#include "solver/scene/check.h"
#include "ui/document/drawing.h"

#include <atomic>
#include <memory>
#include <vector>

namespace keyblock {

/// What a check found.
struct Checked {
    std::shared_ptr<const Scene> scene;
    std::vector<Problem> problems;
    std::shared_ptr<const SceneCut> cut;  // null: errors keep it from being cut, or it needs none
    std::shared_ptr<const SectionPicture> picture;  // as drawn; null: errors, or no blocks
};

/// Checks, cuts and draws a scene here and now; whatever goes wrong is a problem.
/// \param stop where it becomes true, it ends soon with what it has; null: it goes to its end.
std::shared_ptr<const Checked> checkedOf(const std::shared_ptr<const Scene>& scene,
                                         const std::atomic<bool>* stop = nullptr);

}  // namespace keyblock
