// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads the scene of a command that runs it many times.
#pragma once

#include "solver/files/scene/scene_file.h"

#include <filesystem>
#include <optional>
#include <span>
#include <string>

namespace keyblock::cli {

/// The scene if it can be run. Otherwise prints the reasons on standard error.
std::optional<SceneReading> runnableScene(const std::filesystem::path& path, std::span<const std::string> overrides);

}  // namespace keyblock::cli
