// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/journal_file.h"

#include "solver/files/scene/scene_file.h"
#include "solver/files/atomic_file.h"
#include "solver/run/write_error.h"
#include "ui/document/journal_text.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <exception>

namespace keyblock {

namespace {

constexpr std::chrono::seconds beforeRetry{2};  // after a failed write

}  // namespace

JournalFile::JournalFile(const std::filesystem::path& path, std::function<void(std::string)> report)
    : path_(path), report_(std::move(report)),
      file_(::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_APPEND | O_CLOEXEC, 0600)) {
    if (file_ < 0) throw CannotWrite(cannotWriteText(path, errno));
    ::flock(file_, LOCK_EX);  // another window locks it only briefly to read it
    thread_ = std::thread([this] { work(); });
}

JournalFile::~JournalFile() {
    {
        const std::lock_guard lock(mutex_);
        ends_ = true;
    }
    wake_.notify_one();
    thread_.join();
    ::close(file_);
}

void JournalFile::begin(const std::string& path, const std::string& name, ScenePtr first, bool isSaved) {
    hand([=, this] { return journalBegin(path, name, textOf(first), isSaved); });
}

void JournalFile::begin(std::string lines) {
    hand([lines = std::move(lines)]() mutable { return std::move(lines); });
}

void JournalFile::step(std::size_t index, const std::string& name, ScenePtr before, ScenePtr after) {
    hand([=, this] {
        if (!before) return journalWholeStep(index, name, textOf(after));
        const std::string from = textOf(before);
        return journalStep(index, name, from, textOf(after));
    });
}

void JournalFile::move(std::size_t index) {
    hand([=] { return journalMove(index); });
}

void JournalFile::saved(std::optional<std::size_t> index, const std::string& path) {
    hand([=] { return journalSaved(index, path); });
}

bool JournalFile::flush() {
    std::unique_lock lock(mutex_);
    idle_.wait(lock, [this] { return waiting_.empty() && !works_; });
    return !failing_ && !broken_;
}

void JournalFile::remove() {
    {
        const std::lock_guard lock(mutex_);
        waiting_.clear();
    }
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
}

void JournalFile::hand(std::function<std::string()> line) {
    {
        const std::lock_guard lock(mutex_);
        waiting_.push_back(std::move(line));
    }
    wake_.notify_one();
}

const std::string& JournalFile::textOf(const ScenePtr& scene) {
    if (scene != written_) {
        text_ = wholeSceneText(*scene);
        written_ = scene;
    }
    return text_;
}

void JournalFile::write(const std::string& line) {
    std::size_t done = 0;
    while (done < line.size()) {
        const ssize_t n = ::write(file_, line.data() + done, line.size() - done);
        if (n < 0 && errno == EINTR) continue;
        if (n <= 0) throw CannotWrite(cannotWriteText(path_, errno));
        done += static_cast<std::size_t>(n);
    }
}

/// Writes the waiting lines. A line that cannot be written stays in the queue, with those after it, until there is room
/// on the disk.
void JournalFile::writeUnwritten() {
    try {
        for (; !unwritten_.empty(); unwritten_.pop_front()) {
            write(unwritten_.front());
            size_ += unwritten_.front().size();
        }
        if (failing_) report_({});
        failing_ = false;
    } catch (const CannotWrite& error) {
        // if this fails, an incomplete line stays at the end of the file
        if (::ftruncate(file_, static_cast<off_t>(size_)) != 0) broken_ = true;
        failing_ = true;
        report_(error.what());
    }
}

void JournalFile::work() {
    for (;;) {
        std::function<std::string()> line;
        {
            std::unique_lock lock(mutex_);
            works_ = false;
            if (waiting_.empty()) idle_.notify_all();
            const auto isCalled = [this] { return ends_ || !waiting_.empty(); };
            if (unwritten_.empty()) wake_.wait(lock, isCalled);
            else wake_.wait_for(lock, beforeRetry, isCalled);
            if (waiting_.empty() && ends_) return;
            if (!waiting_.empty()) {
                line = std::move(waiting_.front());
                waiting_.pop_front();
            }
            works_ = true;
        }
        if (broken_) continue;
        try {
            if (line) unwritten_.push_back(line());
            writeUnwritten();
        } catch (const std::exception& error) {
            broken_ = true;
            unwritten_.clear();
            report_(error.what());
        }
    }
}

}  // namespace keyblock
