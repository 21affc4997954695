// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Checks, cuts and draws a scene: the work that the document does in the background for
// every new scene.
#pragma once

#include "solver/scene/check.h"
#include "ui/document/preview.h"

#include <atomic>
#include <memory>
#include <vector>

namespace keyblock {

/// A scene with the results of its check.
struct Checked {
    std::shared_ptr<const Scene> scene;
    std::vector<Problem> problems;
    std::shared_ptr<const SceneCut> cut;  // null: the scene has errors, or needs no cut
    std::shared_ptr<const SectionPicture> picture;  // null: the scene has errors, or no blocks
};

/// Checks, cuts and draws a scene synchronously. Exceptions are reported as problems.
/// \param stop if this becomes true, the work ends early with a partial result; null: the work is not stopped
std::shared_ptr<const Checked> checkedOf(const std::shared_ptr<const Scene>& scene,
                                         const std::atomic<bool>* stop = nullptr);

}  // namespace keyblock
