// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/journal_file.h"

#include "solver/files/scene_file.h"
#include "solver/files/whole_file.h"
#include "solver/run/errors.h"
#include "ui/document/journal_text.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <exception>

namespace keyblock {

JournalFile::JournalFile(const std::filesystem::path& path, std::function<void(std::string)> told)
    : path_(path), told_(std::move(told)),
      file_(::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_APPEND | O_CLOEXEC, 0600)) {
    if (file_ < 0) throw CannotWrite(cannotWriteText(path, errno));
    ::flock(file_, LOCK_EX);  // another window that looks at it holds it for a moment only
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

void JournalFile::step(std::size_t index, const std::string& name, ScenePtr before, ScenePtr after) {
    hand([=, this] {
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

void JournalFile::flush() {
    std::unique_lock lock(mutex_);
    idle_.wait(lock, [this] { return waiting_.empty() && !works_; });
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

/// After a line that could not be written, later ones would be damage: nothing more is written, and that is told.
void JournalFile::work() {
    for (;;) {
        std::function<std::string()> line;
        {
            std::unique_lock lock(mutex_);
            works_ = false;
            if (waiting_.empty()) idle_.notify_all();
            wake_.wait(lock, [this] { return ends_ || !waiting_.empty(); });
            if (waiting_.empty()) return;
            line = std::move(waiting_.front());
            waiting_.pop_front();
            works_ = true;
        }
        if (broken_) continue;
        try {
            write(line());
        } catch (const std::exception& error) {
            broken_ = true;
            told_(error.what());
        }
    }
}

}  // namespace keyblock
