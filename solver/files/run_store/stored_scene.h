// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The scene of a run store as given by the user, before cutting.
#pragma once

#include "solver/scene/scene.h"

#include <filesystem>

namespace keyblock {

/// Reads the scene of a run store, including its records.
/// \throws CannotRead if the file is missing, is not a run store, is of another version or is damaged, or if this
/// program does not accept the scene.
Scene storedScene(const std::filesystem::path& store);

}  // namespace keyblock
