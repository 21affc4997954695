// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Checks a scene: numbers in range, names that refer to existing objects, valid block
// outlines, bolts that run through rock. Scenes read from a file and scenes built in
// code are checked in the same way.
#pragma once

#include "solver/scene/problem.h"
#include "solver/scene/scene.h"
#include "solver/scene/scene_cut.h"

#include <atomic>
#include <optional>
#include <vector>

namespace keyblock {

/// All problems of a scene, in the order of its parts, with pointers but without file and line. Accepts any scene,
/// however invalid. A scene without errors can be run.
/// \param cut receives the result of cutting the scene; it is empty if no cut is needed or if errors prevent one.
/// \param stop if it becomes true, the check ends early and its result must not be used; null: the check cannot be
///        stopped.
std::vector<Problem> checkScene(const Scene& scene, std::optional<SceneCut>* cut = nullptr,
                                const std::atomic<bool>* stop = nullptr);

/// Only the problems of single values: numbers out of range, empty names, and fields that do not apply.
std::vector<Problem> checkValues(const Scene& scene);

}  // namespace keyblock
