// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Files that no export or import replaces: what it reads from, run stores, and scenes.
// A wrong name after `--out` must not cost hours of computing or drawing.
#pragma once

#include <filesystem>
#include <span>
#include <string>

namespace keyblock {

/// Whether a scene may be replaced, as by an import.
enum class Scenes { Kept, Replaced };

/// Why the file at `path` must not be replaced, as in "'a.kbrun' is a run store"; empty if it may be, or if there is no
/// such file. Links are followed.
/// \param sources the files that are read to write this one.
std::string whyKept(const std::filesystem::path& path, std::span<const std::filesystem::path> sources,
                    Scenes scenes = Scenes::Kept);

/// \throws CannotWrite if the file must not be replaced.
void requireReplaceable(const std::filesystem::path& path, std::span<const std::filesystem::path> sources,
                        Scenes scenes = Scenes::Kept);

}  // namespace keyblock
