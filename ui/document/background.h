// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Slow work on one background thread. Only the newest request is run: a waiting
// request that is overtaken is never started.
#pragma once

#include <QObject>

#include <atomic>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>

namespace keyblock {

class Background : public QObject {
    Q_OBJECT

public:
    explicit Background(QObject* parent = nullptr);
    /// Waits for the running job; its result is dropped.
    ~Background() override;

    /// Delivers the result of a job in the window's thread; may be empty.
    using Result = std::function<void()>;

    /// Runs the job on the thread, replacing a waiting one; its result runs in this object's thread. A job
    /// reports errors through its result.
    void ask(std::function<Result()> job);

    /// For use in a job: it was overtaken or is no longer wanted.
    bool isOvertaken() const { return overtaken_; }

    /// For use in a job whose result is wanted even if it is overtaken: true once it is no longer wanted.
    const std::atomic<bool>& ends() const { return ends_; }

private:
    void work();

    std::mutex mutex_;
    std::condition_variable wake_;
    std::function<Result()> next_;
    std::atomic<bool> ends_{false}, overtaken_{false};
    std::thread thread_;
};

}  // namespace keyblock
