// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is left to do of a run that has a store already. Going on is allowed only
// where the result is the same as if the run had never been interrupted: with the
// same scene and the same build of the program.
#pragma once

#include "solver/run/checkpoint.h"
#include "solver/scene/scene.h"

#include <filesystem>
#include <optional>

namespace keyblock {

struct Resumption {
    bool finished = false;  // nothing is left to do
    std::optional<Checkpoint> checkpoint;  // where to resume; none: from the beginning
};

/// A store that is not there, or an empty file, means from the beginning.
/// \throws CannotRead for a file that is not a run store or is damaged, and for a store of another scene or build.
Resumption resumptionOf(const std::filesystem::path& store, const Scene& scene);

}  // namespace keyblock
