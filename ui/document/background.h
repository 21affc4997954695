// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Slow work on one background thread, one job at a time. Usually only the newest
// request is run, and a waiting one that is overtaken is never started; where every
// request counts, they are run in order.
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
    /// Waits for the running job; its result is dropped, and so are waiting jobs.
    ~Background() override;

    /// Delivers the result of a job in the window's thread; may be empty.
    using Result = std::function<void()>;

    /// Runs the job on the thread, replacing waiting ones; its result runs in this object's thread. A job
    /// reports errors through its result.
    void ask(std::function<Result()> job);

    /// The same after the waiting ones; overtakes none.
    void add(std::function<Result()> job);

    /// For use in a job: it was overtaken or is no longer wanted.
    bool isOvertaken() const { return overtaken_; }

    /// For use in a job whose result is wanted even if it is overtaken: true once it is no longer wanted.
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
