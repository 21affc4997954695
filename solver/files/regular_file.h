// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Only regular files are read: opening a named pipe waits for its writer, and a device
// may never end.
#pragma once

#include <filesystem>
#include <string>

namespace keyblock {

/// What is at `path` if it is not a regular file, e.g. "a folder"; empty for a regular file, a link to one, or nothing.
std::string specialFileAt(const std::filesystem::path& path);

}  // namespace keyblock
