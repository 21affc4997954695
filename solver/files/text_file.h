// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads files that users name. A device or a pipe could be endless, or block the
// program forever, so only regular files are opened, and no more than a limit is read.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace keyblock {

struct TextFileLimits {
    std::uint64_t bytes = 0;
    std::string whatToGive;  // remedy for what is not a file: "give the name of a CSV file"
    std::string ifTooLong;  // remedy: "give fewer rows"
};

/// The contents of a file. \throws CannotRead if it is not a regular file, cannot be opened or is too long.
std::string readTextFile(const std::filesystem::path& path, const TextFileLimits& limits);

}  // namespace keyblock
