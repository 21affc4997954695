// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Checks a checkpoint before a run takes it. A run store may come from any source, and
// the engine uses the indices and lists of a checkpoint without further checks.
#pragma once

#include "solver/run/checkpoint.h"
#include "solver/scene/scene.h"

#include <optional>
#include <stdexcept>
#include <string>

namespace keyblock {

/// Thrown by `run` if a checkpoint does not belong to the scene; nothing was written then.
struct UnfitCheckpoint : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Name of the first part of the checkpoint that contradicts the model or the scene: an index out of range, a list of
/// the wrong length or a number that is not finite. None if every step can use the checkpoint.
/// \param scene the scene as solved, i.e. after cutting. \param model the model of that scene.
std::optional<std::string> misfitOf(const Checkpoint& checkpoint, const Model& model, const Scene& scene);

}  // namespace keyblock
