// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/files/run_store/store_lock.h"

#include "solver/files/atomic_file.h"
#include "solver/run/write_error.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>

namespace keyblock {

StoreLock::StoreLock(const std::filesystem::path& path) : file_(::open(path.c_str(), O_RDONLY | O_CLOEXEC)) {
    if (file_ < 0)
        throw CannotWrite(cannotWriteText(path, errno));
    if (::flock(file_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK)
        return;  // locked, or the file system has no locks
    ::close(file_);
    throw CannotWrite("cannot write " + path.string() +
                      ": another run is writing it; wait for it or stop it, or choose another --out");
}

StoreLock::~StoreLock() { ::close(file_); }

bool StoreLock::isAt(const std::filesystem::path& path) const {
    struct stat own {
    }, there{};
    if (::fstat(file_, &own) != 0) return true;
    if (::stat(path.c_str(), &there) != 0) return errno != ENOENT && errno != ENOTDIR;
    return own.st_dev == there.st_dev && own.st_ino == there.st_ino;
}

std::filesystem::path StoreLock::presentPath() const {
    std::error_code error;
    const std::filesystem::path now = std::filesystem::read_symlink("/proc/self/fd/" + std::to_string(file_), error);
    return !error && isAt(now) ? now : std::filesystem::path();
}

}  // namespace keyblock
