// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Makes the run store of a finished run smaller: most of it are frames.
#pragma once

#include "solver/scene/scene.h"

#include <filesystem>

namespace keyblock {

/// Replaces the store of a finished run of `scene` by one with the first and the last frame of each stage, and all
/// history and events. \throws CannotRead, CannotWrite
void thinStore(const std::filesystem::path& path, const Scene& scene);

}  // namespace keyblock
