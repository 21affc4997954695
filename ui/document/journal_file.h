// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes a journal on its own thread, because writing a large scene would block the
// window. `Background` is not used: lines that cannot be written are retried, the
// window can wait for them, and the last ones are written before the thread ends. Each
// line is written by one system call, so that a killed program leaves only whole lines.
// The file is locked while it is in use, and the lock ends with the process; an
// existing journal without a lock was therefore not closed.
#pragma once

#include "solver/scene/scene.h"

#include <atomic>
#include <condition_variable>
#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

namespace keyblock {

class JournalFile {
public:
    using ScenePtr = std::shared_ptr<const Scene>;

    /// Creates the file.
    /// \param report called from the writer's thread: with an error message if writing stops (e.g. because the disk is
    /// full), and with an empty string once all lines have been written after an error
    /// \throws CannotWrite
    JournalFile(const std::filesystem::path& path, std::function<void(std::string)> report);
    /// Writes pending lines, then closes and unlocks the file.
    ~JournalFile();
    JournalFile(const JournalFile&) = delete;
    JournalFile& operator=(const JournalFile&) = delete;

    void begin(const std::string& path, const std::string& name, ScenePtr first, bool isSaved);
    /// Starts with a copy of the lines of another journal, in order to continue it.
    void begin(std::string lines);
    /// Writes an undo step. \param before the previous scene; null: unknown, so that the whole scene `after` is written
    /// instead of its differences
    void step(std::size_t index, const std::string& name, ScenePtr before, ScenePtr after);
    void move(std::size_t index);
    void saved(std::optional<std::size_t> index, const std::string& path);

    /// Waits until all lines so far are written; returns false if some could not be written to disk.
    bool flush();
    /// Removes the file. Pending lines are not written.
    void remove();

    const std::filesystem::path& path() const { return path_; }

private:
    void hand(std::function<std::string()> line);
    void work();
    void write(const std::string& line);
    void writeUnwritten();
    const std::string& textOf(const ScenePtr& scene);

    std::filesystem::path path_;
    std::function<void(std::string)> report_;
    int file_ = -1;
    std::atomic<bool> broken_{false};  // a line is missing or incomplete, so that no more are written
    std::deque<std::string> unwritten_;  // writer's thread: lines that could not be written to disk yet
    std::atomic<bool> failing_{false};  // the last attempt to write failed
    std::size_t size_ = 0;  // size of the complete lines in the file [bytes]
    ScenePtr written_;  // writer's thread: the scene whose text is in `text_`
    std::string text_;
    std::mutex mutex_;
    std::condition_variable wake_, idle_;
    std::deque<std::function<std::string()>> waiting_;
    bool works_ = false, ends_ = false;
    std::thread thread_;
};

}  // namespace keyblock
