// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Atomic writes: a file is written under a temporary name in the same folder and
// renamed at the end, so that readers see the complete file or none.
#pragma once

#include <filesystem>
#include <functional>
#include <ostream>
#include <string>

namespace keyblock {

/// One-line message stating that `path` cannot be written, with the reason and a remedy.
/// \param systemError the system error number (errno); 0 if there is none.
/// \param reason an additional explanation.
std::string cannotWriteText(const std::filesystem::path& path, int systemError, const std::string& reason = {});

/// Temporary name of a file or folder while it is being written: `path` with `.part-` and the process ID appended.
std::filesystem::path partPath(const std::filesystem::path& path);

/// Removes temporary files and folders of `path` whose processes no longer exist, e.g. because they were killed.
void removeOldParts(const std::filesystem::path& path);

/// Removes old temporary files of `path` and creates an empty one for this process. The file is new: no link at its path
/// is followed. \return `partPath(path)`. \throws CannotWrite
std::filesystem::path makePartFile(const std::filesystem::path& path);

/// Writes a file atomically, replacing an existing one. A device or a pipe is written to directly.
/// \param write writes the contents. \throws CannotWrite; an existing file is then unchanged.
void writeAtomically(const std::filesystem::path& path, const std::function<void(std::ostream&)>& write);

}  // namespace keyblock
