// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// ffmpeg runs in its own process group, so that Ctrl+C reaches only this program,
// which then stops it. The program never waits indefinitely for either pipe.
#include "solver/files/movie_file.h"

#include "solver/files/atomic_file.h"
#include "solver/run/write_error.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <sstream>

namespace keyblock {

namespace {

namespace fs = std::filesystem;

constexpr int patience = 20;  // interval between checks of `stop` [ms]

/// Path of a program with this name; empty if it is not found.
std::string findProgram(const std::string& name) {
    const char* path = ::getenv("PATH");
    std::istringstream folders(path ? path : "");
    for (std::string folder; std::getline(folders, folder, ':');)
        if (const fs::path file = fs::path(folder) / name; !folder.empty() && ::access(file.c_str(), X_OK) == 0)
            return file.string();
    return {};
}

std::vector<std::string> wordsFor(const fs::path& out, MovieFormat format, const MovieShape& shape) {
    std::vector<std::string> words{"ffmpeg", "-hide_banner", "-nostdin", "-loglevel", "error", "-y",
                                   "-f", "rawvideo", "-pixel_format", "bgr0",
                                   "-video_size", std::to_string(shape.columns) + "x" + std::to_string(shape.rows),
                                   "-framerate", std::to_string(shape.perSecond), "-i", "pipe:0", "-an",
                                   "-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2:color=white,"
                                          "scale=out_color_matrix=bt709:out_range=tv,format=yuv420p",
                                   "-colorspace", "bt709", "-color_primaries", "bt709", "-color_trc", "bt709",
                                   "-color_range", "tv", "-map_metadata", "-1", "-fflags", "+bitexact",
                                   "-flags:v", "+bitexact"};
    const std::vector<std::string> h264{"-c:v", "libx264", "-preset", "medium", "-crf", "18", "-movflags", "+faststart",
                                        "-f", "mp4"};
    const std::vector<std::string> vp9{"-c:v", "libvpx-vp9", "-crf", "24", "-b:v", "0", "-deadline", "good",
                                       "-cpu-used", "5", "-row-mt", "1", "-f", "webm"};
    const std::vector<std::string>& codec = format == MovieFormat::Mp4 ? h264 : vp9;
    words.insert(words.end(), codec.begin(), codec.end());
    words.push_back("file:" + out.string());
    return words;
}

struct Pipe {
    int from = -1, into = -1;
};

Pipe openPipe(const fs::path& shown) {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw CannotWrite(cannotWriteText(shown, errno));
    return {ends[0], ends[1]};
}

void close(int& descriptor) {
    if (descriptor >= 0) ::close(descriptor);
    descriptor = -1;
}

/// Starts a child process with its own process group and default signal handling.
int spawn(const std::string& program, const std::vector<std::string>& words, int input, int messages, int& process) {
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, input, STDIN_FILENO);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, messages, STDERR_FILENO);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    sigset_t defaults;
    sigemptyset(&defaults);
    for (const int signal : {SIGPIPE, SIGXFSZ, SIGINT, SIGTERM}) sigaddset(&defaults, signal);
    posix_spawnattr_setsigdefault(&attributes, &defaults);
    posix_spawnattr_setpgroup(&attributes, 0);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF);
    std::vector<char*> arguments;
    for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    const int error = ::posix_spawn(&process, program.c_str(), &actions, &attributes, arguments.data(), environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    return error;
}

}  // namespace

bool canWriteMovies() { return !findProgram("ffmpeg").empty(); }

MovieFile::MovieFile(const fs::path& path, MovieFormat format, const MovieShape& shape, const std::atomic<bool>& stop)
    : path_(path), part_(partPath(path)), stop_(stop) {
    if (fs::is_directory(path)) throw CannotWrite(cannotWriteText(path, EISDIR));
    makePartFile(path);  // reports an error at once, and more clearly than ffmpeg would later
    const std::string program = findProgram("ffmpeg");
    if (program.empty()) {
        fs::remove(part_);
        throw CannotWrite("cannot write " + path.string() +
                          ": the program ffmpeg, which writes animations, is not found; " +
                          "install it (on Debian: apt install ffmpeg), or name a folder instead for PNG images");
    }
    start(program, wordsFor(part_, format, shape));
}

void MovieFile::start(const std::string& program, const std::vector<std::string>& words) {
    Pipe input = openPipe(path_), messages = openPipe(path_);
    const int error = spawn(program, words, input.from, messages.into, process_);
    close(input.from);
    close(messages.into);
    input_ = input.into;
    messages_ = messages.from;
    ::fcntl(input_, F_SETFL, O_NONBLOCK);
    ::fcntl(messages_, F_SETFL, O_NONBLOCK);
    if (error == 0) return;
    process_ = -1;
    said_ = "ffmpeg does not start";
    fail();
}

MovieFile::~MovieFile() {
    if (process_ > 0) {
        ::kill(process_, SIGKILL);
        ::waitpid(process_, nullptr, 0);
    }
    close(input_);
    close(messages_);
    std::error_code ignored;
    fs::remove(part_, ignored);
}

void MovieFile::readMessages() {
    std::array<char, 4096> buffer{};
    for (ssize_t n = 0; (n = ::read(messages_, buffer.data(), buffer.size())) > 0;)
        if (said_.size() < 2000) said_.append(buffer.data(), static_cast<std::size_t>(n));
}

bool MovieFile::hasEnded() {
    readMessages();
    if (process_ > 0 && ::waitpid(process_, &status_, WNOHANG) == process_) process_ = -1;
    return process_ < 0;
}

/// A message with the name of the file in place of its temporary name.
std::string MovieFile::named(std::string text) const {
    const std::string part = part_.string();
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at))
        text.replace(at, part.size(), path_.string());
    return text;
}

/// The first line of ffmpeg's messages gives the cause; the following lines result from it.
void MovieFile::fail() {
    const std::string why = named(said_.substr(0, said_.find('\n')));
    throw CannotWrite("cannot write " + path_.string() + ": ffmpeg failed: " +
                      (why.empty() ? "it gave no reason" : why) +
                      "; check the free space and the codecs of ffmpeg, or name a folder for PNG images");
}

void MovieFile::add(const std::string& pixels) {
    for (std::size_t done = 0; done < pixels.size() && !stop_;) {
        std::array<pollfd, 2> waits{{{input_, POLLOUT, 0}, {messages_, POLLIN, 0}}};
        ::poll(waits.data(), waits.size(), patience);
        const ssize_t n = ::write(input_, pixels.data() + done, pixels.size() - done);
        if (n > 0) done += static_cast<std::size_t>(n);
        const bool gone = n < 0 && errno == EPIPE;
        readMessages();
        if (!gone) continue;
        close(input_);
        while (!hasEnded() && !stop_) ::poll(nullptr, 0, patience);
        fail();
    }
}

void MovieFile::finish() {
    close(input_);
    while (!hasEnded() && !stop_) ::poll(nullptr, 0, patience);
    if (stop_) return;
    readMessages();
    if (!WIFEXITED(status_) || WEXITSTATUS(status_) != 0) fail();
    std::error_code error;
    if (fs::file_size(part_, error) == 0 || error) {
        said_ = "it wrote nothing";
        fail();
    }
    fs::rename(part_, path_, error);
    if (error) throw CannotWrite(cannotWriteText(path_, error.value()));
}

}  // namespace keyblock
