// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes a video as MP4 or WebM with the program ffmpeg. Images are sent to ffmpeg
// through a pipe, and the file gets its final name once it is complete.
#pragma once

#include <atomic>
#include <filesystem>
#include <string>
#include <vector>

namespace keyblock {

enum class MovieFormat { Mp4, WebM };  // H.264 and VP9

struct MovieShape {
    int columns = 0, rows = 0;  // size of an image [px]; an odd size is increased by one white line
    int perSecond = 12;  // images per second
};

/// Whether ffmpeg is installed.
bool canWriteMovies();

class MovieFile {
public:
    /// Starts ffmpeg.
    /// \param stop ends any wait for ffmpeg once it is set, e.g. by another thread; it must outlive this object.
    /// \throws CannotWrite if ffmpeg is not installed or the file cannot be written.
    MovieFile(const std::filesystem::path& path, MovieFormat format, const MovieShape& shape,
              const std::atomic<bool>& stop);
    /// Terminates ffmpeg and deletes the file if it is unfinished.
    ~MovieFile();
    MovieFile(const MovieFile&) = delete;
    MovieFile& operator=(const MovieFile&) = delete;

    /// Adds an image. Does nothing once `stop` is set.
    /// \param pixels the rows of the image from the top, four bytes per pixel: blue, green, red and an unused byte.
    /// \throws CannotWrite with ffmpeg's message if ffmpeg has failed.
    void add(const std::string& pixels);

    /// Waits for ffmpeg and gives the file its final name, unless `stop` is set.
    /// \throws CannotWrite with ffmpeg's message if ffmpeg has failed.
    void finish();

private:
    void start(const std::string& program, const std::vector<std::string>& words);
    void readMessages();
    bool hasEnded();
    std::string named(std::string text) const;
    [[noreturn]] void fail();

    std::filesystem::path path_, part_;
    const std::atomic<bool>& stop_;
    int process_ = -1;
    int input_ = -1, messages_ = -1;  // ends of pipes
    int status_ = 0;
    std::string said_;  // messages of ffmpeg
};

}  // namespace keyblock
