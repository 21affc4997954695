// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Runs slow work on one background thread, one job at a time. Usually only the newest
// request matters: a waiting job that a newer one replaces is never started. If every
// request matters, the jobs are run in order.
#pragma once

#include <QObject>

#include <atomic>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>

namespace keyblock {

class Background : public QObject {
    Q_OBJECT

public:
    explicit Background(QObject* parent = nullptr);
    /// Waits for the running job. Its result and all waiting jobs are discarded.
    ~Background() override;

    /// Delivers the result of a job; runs in the thread of this object. May be empty.
    using Result = std::function<void()>;

    /// Discards all waiting jobs. Then runs the job on the background thread, and its `Result` in the thread of this
    /// object. A job reports errors through its result.
    void ask(std::function<Result()> job);

    /// Like `ask`, but does not discard the waiting jobs; the new job runs after them.
    void add(std::function<Result()> job);

    /// To be called by a job: true if a newer request replaces this job, or its result is no longer wanted.
    bool isOvertaken() const { return overtaken_; }

    /// For a job that should finish even if a newer request follows: true once this object is being destroyed, so that
    /// the result is no longer wanted.
    const std::atomic<bool>& ends() const { return ends_; }

private:
    void work();

    std::mutex mutex_;
    std::condition_variable wake_;
    std::deque<std::function<Result()>> waiting_;
    std::atomic<bool> ends_{false}, overtaken_{false};
    std::thread thread_;
};

}  // namespace keyblock
