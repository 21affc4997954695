// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A symbolic link is followed, so that the link stays and its target is replaced.
#include "solver/files/atomic_file.h"

#include "solver/run/write_error.h"

#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <ext/stdio_filebuf.h>
#include <string_view>
#include <system_error>
#include <vector>

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

/// Creates a file that does not exist yet and opens it for writing. What lies at its path is removed, not followed.
/// \return −1 on failure, with the reason in errno.
int createdNew(const fs::path& path) {
    constexpr int flags = O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC;
    const int file = ::open(path.c_str(), flags, 0666);
    if (file >= 0 || errno != EEXIST || ::unlink(path.c_str()) != 0) return file;
    return ::open(path.c_str(), flags, 0666);
}

/// Removes the unfinished file unless it was put in its place.
class PartFile {
public:
    /// \param shown the path for messages. \throws CannotWrite
    PartFile(const fs::path& target, const fs::path& shown) : path_(partPath(target)) {
        removeOldParts(target);
        file_ = createdNew(path_);
        if (file_ < 0) fail(shown, errno);
    }
    ~PartFile() {
        std::error_code ignored;
        fs::remove(path_, ignored);
    }
    PartFile(const PartFile&) = delete;
    PartFile& operator=(const PartFile&) = delete;

    const fs::path& path() const { return path_; }
    /// The open file; the caller closes it.
    int file() const { return file_; }

private:
    fs::path path_;
    int file_ = -1;
};

/// Writes into an open file and closes it.
void writeInto(int file, const fs::path& shown, const std::function<void(std::ostream&)>& write) {
    errno = 0;
    __gnu_cxx::stdio_filebuf<char> buffer(file, std::ios::out | std::ios::binary);
    std::ostream out(&buffer);
    write(out);
    out.flush();
    const bool closed = buffer.close() != nullptr;
    if (!out || !closed) fail(shown, errno != 0 ? errno : EIO);
}

/// Process whose temporary file or folder of `name` this is; 0 if it is none.
pid_t processOf(std::string_view part, const std::string& name) {
    const std::string start = name + ".part-";
    if (!part.starts_with(start)) return 0;
    part.remove_prefix(start.size());
    pid_t process = 0;
    const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), process);
    const std::string_view rest(end, part.data() + part.size());
    const bool isOurs = rest.empty() || rest == "-journal" || rest == "-wal" || rest == "-shm";  // the rest by SQLite
    return error == std::errc() && process > 0 && isOurs ? process : 0;
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

void removeOldParts(const fs::path& path) {
    const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    if (folder.filename().string().find(".part-") != std::string::npos)
        return;  // a folder that this process is filling has none
    std::error_code error;
    std::vector<fs::path> old;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
        const pid_t process = processOf(entry->path().filename().string(), path.filename().string());
        if (process != 0 && process != ::getpid() && ::kill(process, 0) != 0 && errno == ESRCH)
            old.push_back(entry->path());
    }
    for (const fs::path& part : old) fs::remove_all(part, error);
}

fs::path makePartFile(const fs::path& path) {
    removeOldParts(path);
    const fs::path part = partPath(path);
    const int file = createdNew(part);
    if (file < 0) fail(path, errno);
    ::close(file);
    return part;
}

void writeAtomically(const fs::path& path, const std::function<void(std::ostream&)>& write) {
    if (isDeviceOrPipe(path)) {
        const int file = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
        if (file < 0) fail(path, errno);
        return writeInto(file, path, write);
    }
    const fs::path target = linkTarget(path);
    const PartFile part(target, path);
    writeInto(part.file(), path, write);
    std::error_code error;
    fs::rename(part.path(), target, error);
    if (error)
        fail(path, error.value());
}

}  // namespace keyblock
