// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Ensures that only one run at a time writes to a store. SQLite only separates single
// transactions; two runs that continue the same store would corrupt it. The system
// releases the lock when the process ends, however it ends.
#pragma once

#include <filesystem>

namespace keyblock {

/// Holds the lock on a store for the lifetime of this object. Its destructor closes the file, which also releases
/// SQLite's own locks.
/// \pre the file exists, and all SQLite connections to it are closed before this object is destroyed.
class StoreLock {
public:
    /// Takes the lock. \throws CannotWrite if another run holds it, or if the file cannot be opened.
    explicit StoreLock(const std::filesystem::path& path);
    ~StoreLock();
    StoreLock(const StoreLock&) = delete;
    StoreLock& operator=(const StoreLock&) = delete;

    /// Whether the file at `path` is the one that was locked, or the file system does not tell.
    bool isAt(const std::filesystem::path& path) const;
    /// Path at which the locked file is now; empty if it was deleted or its path is unknown.
    std::filesystem::path presentPath() const;

private:
    int file_ = -1;
};

}  // namespace keyblock
