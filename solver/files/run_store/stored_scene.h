// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The scene of a run store as it was written, before it was cut and run.
#pragma once

#include "solver/scene/scene.h"

#include <filesystem>

namespace keyblock {

/// With its records inside. \throws CannotRead for a file that is missing, is not a run store, is of another version or
/// is damaged, and where this program does not accept the scene.
Scene storedScene(const std::filesystem::path& store);

}  // namespace keyblock
