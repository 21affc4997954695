// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Determines how to resume a run from its store. Resuming is allowed only if the
// results are the same as without the interruption: with the same scene, the
// same build of the program and the same kernel of OpenBLAS.
#pragma once

#include "solver/run/checkpoint.h"
#include "solver/scene/scene.h"

#include <filesystem>
#include <optional>

namespace keyblock {

struct Resumption {
    bool finished = false;  // the run is complete
    std::optional<Checkpoint> checkpoint;  // state from which to resume; none: start from the beginning
};

/// Determines how to resume the run of `scene` from a store. If the file `store` does not exist or is empty, the run
/// starts from the beginning.
/// \throws CannotRead if the file is not a run store or is damaged, or if it belongs to another scene or build,
/// or was begun with another kernel of OpenBLAS.
Resumption resumptionOf(const std::filesystem::path& store, const Scene& scene);

}  // namespace keyblock
