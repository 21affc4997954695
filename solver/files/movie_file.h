// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A video as MP4 or WebM, written by the program ffmpeg: frames go into it through a
// pipe, and the file appears under its name once it is complete.
#pragma once

#include <atomic>
#include <filesystem>
#include <string>
#include <vector>

namespace keyblock {

enum class MovieFormat { Mp4, WebM };  // H.264 and VP9

struct MovieShape {
    int columns = 0, rows = 0;  // of a frame [px]; an odd number gets a white line more
    int perSecond = 12;  // pictures
};

/// Whether ffmpeg is installed.
bool canWriteMovies();

class MovieFile {
public:
    /// Starts ffmpeg. `stop` ends every wait for it and must outlive this.
    /// \throws CannotWrite when there is no ffmpeg, or no right to write there.
    MovieFile(const std::filesystem::path& path, MovieFormat format, const MovieShape& shape,
              const std::atomic<bool>& stop);
    /// Ends ffmpeg and removes what is not finished.
    ~MovieFile();
    MovieFile(const MovieFile&) = delete;
    MovieFile& operator=(const MovieFile&) = delete;

    /// One frame: rows from the top, four bytes a pixel, blue, green, red and one that means nothing. Nothing once
    /// `stop` is set. \throws CannotWrite with ffmpeg's own words when it gave up.
    void add(const std::string& pixels);

    /// Waits for ffmpeg and puts the file in its place, unless `stop` is set. \throws CannotWrite as above.
    void finish();

private:
    void start(const std::string& program, const std::vector<std::string>& words);
    void readMessages();
    bool hasEnded();
    [[noreturn]] void fail();

    std::filesystem::path path_, part_;
    const std::atomic<bool>& stop_;
    int process_ = -1;
    int input_ = -1, messages_ = -1;  // ends of pipes
    int status_ = 0;
    std::string said_;  // by ffmpeg
};

}  // namespace keyblock
