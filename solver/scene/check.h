// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Whether a scene makes sense: numbers in range, names that lead somewhere,
// blocks that are blocks, bolts that lie in them. The same check serves a scene
// read from a file and one built in code.
#pragma once

#include "solver/scene/problem.h"
#include "solver/scene/scene.h"
#include "solver/scene/scene_cut.h"

#include <atomic>
#include <optional>
#include <vector>

namespace keyblock {

/// Everything that is wrong with `scene`, in the order of its parts, with pointers but without file and line.
/// Bears any scene, however broken; a scene without errors can be run.
/// \param cut takes what the scene was cut to; none where it needs no cut, or something keeps it from being cut.
/// \param stop where it becomes true, the check ends soon and says nothing that counts; null: it goes to its end.
std::vector<Problem> checkScene(const Scene& scene, std::optional<SceneCut>* cut = nullptr,
                                const std::atomic<bool>* stop = nullptr);

/// Only what is wrong with single values: ranges, empty names, fields where they do not belong.
std::vector<Problem> checkValues(const Scene& scene);

}  // namespace keyblock
