// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Checks which files a command would replace before it writes any of them.
#pragma once

#include "solver/files/kept_files.h"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace keyblock::cli {

struct OutputFile {
    std::filesystem::path path;
    bool replaces = true;  // an existing file is replaced: its name was given for it, or --overwrite was
    Scenes scenes = Scenes::Kept;
};

/// Reports, with one error line for each, all files that must not be replaced: those that `whyKept` names, and those
/// that exist and are not to be replaced.
/// \param sources the files that the command reads.
/// \return true if all may be written.
bool mayBeWritten(std::span<const OutputFile> files, std::span<const std::filesystem::path> sources);

}  // namespace keyblock::cli
