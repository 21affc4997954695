// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One run at a time writes a store. SQLite only keeps two transactions apart; two
// runs that continue in the same store would corrupt it. The lock goes
// with the process, however that ends.
#pragma once

#include <filesystem>

namespace keyblock {

/// Held while it lives. \pre the file is there, and this goes after every connection to it is closed: closing a file
/// takes SQLite's own locks off.
class StoreLock {
public:
    /// \throws CannotWrite when another process holds it.
    explicit StoreLock(const std::filesystem::path& path);
    ~StoreLock();
    StoreLock(const StoreLock&) = delete;
    StoreLock& operator=(const StoreLock&) = delete;

private:
    int file_ = -1;
};

}  // namespace keyblock
