// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/files/run_store/store_lock.h"

#include "solver/files/atomic_file.h"
#include "solver/run/write_error.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>

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

}  // namespace keyblock
