// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/background.h"

#include <utility>

namespace keyblock {

Background::Background(QObject* parent) : QObject(parent), thread_([this] { work(); }) {}

Background::~Background() {
    {
        const std::scoped_lock lock(mutex_);
        ends_ = overtaken_ = true;
    }
    wake_.notify_one();
    thread_.join();
}

void Background::ask(std::function<Result()> job) {
    {
        const std::scoped_lock lock(mutex_);
        waiting_.clear();
        waiting_.push_back(std::move(job));
        overtaken_ = true;
    }
    wake_.notify_one();
}

void Background::add(std::function<Result()> job) {
    {
        const std::scoped_lock lock(mutex_);
        waiting_.push_back(std::move(job));
    }
    wake_.notify_one();
}

void Background::work() {
    for (;;) {
        std::function<Result()> job;
        {
            std::unique_lock lock(mutex_);
            wake_.wait(lock, [this] { return ends_ || !waiting_.empty(); });
            if (ends_) return;
            job = std::move(waiting_.front());
            waiting_.pop_front();
            overtaken_ = false;
        }
        Result result = job();
        job = nullptr;  // frees its data on this thread, not on that of the window
        if (result) QMetaObject::invokeMethod(this, std::move(result), Qt::QueuedConnection);
    }
}

}  // namespace keyblock
