// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A symbolic link is followed, so that the link stays and its target is replaced.
#include "solver/files/atomic_file.h"

#include "solver/run/write_error.h"

#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <system_error>

namespace keyblock {

namespace {

namespace fs = std::filesystem;

std::string remedyFor(int systemError) {
    switch (systemError) {
        case ENOENT:
        case ENOTDIR: return "create its folder first, or choose another location";
        case EACCES:
        case EPERM:
        case EROFS: return "get permission to write there, or choose another location";
        case ENOSPC:
        case EDQUOT:
        case EFBIG: return "free some space there, or choose another location";
        default: return "choose another location";
    }
}

[[noreturn]] void fail(const fs::path& path, int systemError) {
    throw CannotWrite(cannotWriteText(path, systemError));
}

/// Removes the unfinished file unless it was put in its place.
class PartFile {
public:
    explicit PartFile(const fs::path& target) : path_(partPath(target)) {}
    ~PartFile() {
        std::error_code ignored;
        fs::remove(path_, ignored);
    }
    PartFile(const PartFile&) = delete;
    PartFile& operator=(const PartFile&) = delete;

    const fs::path& path() const { return path_; }

private:
    fs::path path_;
};

void writeInto(const fs::path& file, const fs::path& shown, const std::function<void(std::ostream&)>& write) {
    errno = 0;
    std::ofstream out(file, std::ios::binary | std::ios::trunc);
    if (out) {
        write(out);
        out.close();
    }
    if (!out)
        fail(shown, errno != 0 ? errno : EIO);
}

/// Target of a link, whether or not it exists.
fs::path linkTarget(fs::path path) {
    constexpr int longestChain = 40;
    std::error_code error;
    for (int link = 0; link < longestChain && fs::is_symlink(path, error); ++link) {
        const fs::path target = fs::read_symlink(path, error);
        if (error)
            break;
        path = path.parent_path() / target;  // an absolute target replaces the whole path
    }
    return path;
}

bool isDeviceOrPipe(const fs::path& path) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    return fs::is_character_file(status) || fs::is_fifo(status) || fs::is_socket(status);
}

}  // namespace

std::string cannotWriteText(const fs::path& path, int systemError, const std::string& reason) {
    const std::string system = systemError != 0 ? std::generic_category().message(systemError) : "";
    const std::string both = !reason.empty() && !system.empty() ? reason + " (" + system + ")" : reason + system;
    return "cannot write " + path.string() + ": " + both + "; " + remedyFor(systemError);
}

fs::path partPath(const fs::path& path) {
    fs::path part = path;
    part += ".part-" + std::to_string(::getpid());
    return part;
}

void writeAtomically(const fs::path& path, const std::function<void(std::ostream&)>& write) {
    if (isDeviceOrPipe(path))
        return writeInto(path, path, write);
    const fs::path target = linkTarget(path);
    const PartFile part(target);
    writeInto(part.path(), path, write);
    std::error_code error;
    fs::rename(part.path(), target, error);
    if (error)
        fail(path, error.value());
}

}  // namespace keyblock
