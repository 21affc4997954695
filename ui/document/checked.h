// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Checks, cuts and draws a scene: the background work of the document for every new
// scene.
#pragma once

#include "solver/scene/check.h"
#include "ui/document/preview.h"

#include <atomic>
#include <memory>
#include <vector>

namespace keyblock {

/// The result of a check.
struct Checked {
    std::shared_ptr<const Scene> scene;
    std::vector<Problem> problems;
    std::shared_ptr<const SceneCut> cut;  // null: it has errors, or needs no cut
    std::shared_ptr<const SectionPicture> picture;  // preview frame; null: errors, or no blocks
};

/// Checks, cuts and draws a scene synchronously; exceptions become problems.
/// \param stop when it becomes true, the work ends soon with a partial result; null: it runs to its end.
std::shared_ptr<const Checked> checkedOf(const std::shared_ptr<const Scene>& scene,
                                         const std::atomic<bool>* stop = nullptr);

}  // namespace keyblock
