// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Files that people and programs read appear whole or not at all: they are written
// in the same folder under another name and renamed at the end.
#pragma once

#include <filesystem>
#include <functional>
#include <ostream>
#include <string>

namespace keyblock {

/// One line on why `path` is not written, for the system's error number, with what to do; 0 when the system gave none.
std::string cannotWriteText(const std::filesystem::path& path, int systemError, const std::string& reason = {});

/// The name that a file bears while it is written: next to `path`, ending in `.part-` and the process number.
std::filesystem::path partPath(const std::filesystem::path& path);

/// Writes a file through `write` and puts it in its place, over one that is there. A device or a pipe is written to
/// directly. Throws `CannotWrite`, leaving what was there before.
void writeAtomically(const std::filesystem::path& path, const std::function<void(std::ostream&)>& write);

}  // namespace keyblock
