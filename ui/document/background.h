// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Work that takes longer than the window may wait, on one thread, always the newest:
// what was asked for meanwhile and overtaken is never begun.
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
    /// Waits for the job that runs; its result is dropped.
    ~Background() override;

    /// What is left to do in the window with a job's result; may be empty.
    using Result = std::function<void()>;

    /// Does the job on the thread, in place of one that still waits; its result runs in this object's thread. A job
    /// tells its errors by its result.
    void ask(std::function<Result()> job);

    /// From within a job: another one waits in its place, or nobody does any more.
    bool isOvertaken() const { return overtaken_; }

    /// From within a job whose result is wanted even where it is overtaken: true once nobody waits any more.
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
