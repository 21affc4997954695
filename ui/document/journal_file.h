// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes a journal on a thread of its own, because a large scene takes longer to
// write down than a window may stand still. A line goes to the system with one
// call, so that a kill leaves whole lines. The file is locked while it is written,
// and the lock goes with the process, however that ends: a journal without a lock
// is one that nobody closed.
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

    /// Makes the file. `told` is called from the writer's thread with what keeps it from being written on, a full disk
    /// say, and with nothing once all of it is written after that.
    /// \throws CannotWrite
    JournalFile(const std::filesystem::path& path, std::function<void(std::string)> told);
    /// Writes what waits, and lets go of the file.
    ~JournalFile();
    JournalFile(const JournalFile&) = delete;
    JournalFile& operator=(const JournalFile&) = delete;

    void begin(const std::string& path, const std::string& name, ScenePtr first, bool isSaved);
    /// Goes on from the lines of another.
    void begin(std::string lines);
    /// \param before null: the file holds it, but not from this program.
    void step(std::size_t index, const std::string& name, ScenePtr before, ScenePtr after);
    void move(std::size_t index);
    void saved(std::optional<std::size_t> index, const std::string& path);

    /// Waits until all that was handed over is written; false where the disk did not take all of it yet.
    bool flush();
    /// Removes the file; what waits is not written.
    void remove();

    const std::filesystem::path& path() const { return path_; }

private:
    void hand(std::function<std::string()> line);
    void work();
    void write(const std::string& line);
    void writeUnwritten();
    const std::string& textOf(const ScenePtr& scene);

    std::filesystem::path path_;
    std::function<void(std::string)> told_;
    int file_ = -1;
    std::atomic<bool> broken_{false};  // a line could not be made, later ones would be damage
    std::deque<std::string> unwritten_;  // of the writer's thread: lines that the disk did not take
    std::atomic<bool> failing_{false};  // the last try wrote nothing
    std::size_t size_ = 0;  // of whole lines in the file [bytes]
    ScenePtr written_;  // of the writer's thread: the scene that `text_` is of
    std::string text_;
    std::mutex mutex_;
    std::condition_variable wake_, idle_;
    std::deque<std::function<std::string()>> waiting_;
    bool works_ = false, ends_ = false;
    std::thread thread_;
};

}  // namespace keyblock
