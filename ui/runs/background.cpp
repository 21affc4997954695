// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/runs/background.h"

#include <utility>

namespace keyblock {

Background::Background(QObject* parent) : QObject(parent), thread_([this] { work(); }) {}

Background::~Background() {
    {
        const std::scoped_lock lock(mutex_);
        ends_ = true;
    }
    wake_.notify_one();
    thread_.join();
}

void Background::ask(std::function<Result()> job) {
    {
        const std::scoped_lock lock(mutex_);
        if (!next_) ++open_;
        next_ = std::move(job);
    }
    wake_.notify_one();
}

void Background::work() {
    for (;;) {
        std::function<Result()> job;
        {
            std::unique_lock lock(mutex_);
            wake_.wait(lock, [this] { return ends_ || next_; });
            if (ends_) return;
            job = std::exchange(next_, nullptr);
        }
        Result result = job();
        job = nullptr;  // what it held goes here, not in the window
        QMetaObject::invokeMethod(this, [this, done = std::move(result)] { deliver(done); }, Qt::QueuedConnection);
    }
}

void Background::deliver(const Result& result) {
    --open_;
    if (result) result();
    if (open_ == 0) Q_EMIT becameIdle();
}

}  // namespace keyblock
