// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Keeps two processes from running the same case, e.g. when a task was queued again while
// the first one is still ending. The system releases the lock when a process ends.
#pragma once

#include <filesystem>

namespace keyblock {

class FolderLock {
public:
    /// Tries to take the lock on an existing folder. On a file system without locks it counts as taken.
    explicit FolderLock(const std::filesystem::path& folder);
    ~FolderLock();
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

    bool isHeld() const { return held_; }

private:
    int folder_ = -1;
    bool held_ = true;
};

}  // namespace keyblock
