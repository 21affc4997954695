// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes a journal on its own thread, because writing a large scene would block the
// window. This is not a Background: lines are retried until the disk accepts them, the
// window can wait for them, and the last ones are written before the thread ends.
// A line is written with one system call, so that a kill leaves whole lines. The file
// is locked while it is in use, and the lock ends with the process: a journal without
// a lock was not closed.
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

    /// Creates the file. `report` is called from the writer's thread with an error that stops the writing, such as a
    /// full disk, and with an empty text once everything is written after that.
    /// \throws CannotWrite
    JournalFile(const std::filesystem::path& path, std::function<void(std::string)> report);
    /// Writes pending lines and releases the file.
    ~JournalFile();
    JournalFile(const JournalFile&) = delete;
    JournalFile& operator=(const JournalFile&) = delete;

    void begin(const std::string& path, const std::string& name, ScenePtr first, bool isSaved);
    /// Continues the lines of another journal.
    void begin(std::string lines);
    /// \param before null: it is in the file, but was not written by this program.
    void step(std::size_t index, const std::string& name, ScenePtr before, ScenePtr after);
    void move(std::size_t index);
    void saved(std::optional<std::size_t> index, const std::string& path);

    /// Waits until everything passed so far is written; false if the disk has not accepted all of it yet.
    bool flush();
    /// Removes the file; pending lines are not written.
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
    std::atomic<bool> broken_{false};  // a line could not be created, so later ones would be damaged
    std::deque<std::string> unwritten_;  // writer's thread: lines not accepted by the disk
    std::atomic<bool> failing_{false};  // the last attempt wrote nothing
    std::size_t size_ = 0;  // of whole lines in the file [bytes]
    ScenePtr written_;  // writer's thread: the scene of `text_`
    std::string text_;
    std::mutex mutex_;
    std::condition_variable wake_, idle_;
    std::deque<std::function<std::string()>> waiting_;
    bool works_ = false, ends_ = false;
    std::thread thread_;
};

}  // namespace keyblock
