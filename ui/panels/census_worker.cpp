// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/census_worker.h"

#include <QMetaObject>

#include <exception>

namespace keyblock {

CensusWorker::CensusWorker(QObject* parent) : QObject(parent), thread_([this] { work(); }) {}

CensusWorker::~CensusWorker() {
    {
        const std::lock_guard lock(mutex_);
        ends_ = true;
    }
    wake_.notify_one();
    thread_.join();
}

void CensusWorker::ask(CensusQuestion question) {
    {
        const std::lock_guard lock(mutex_);
        next_ = std::move(question);
        ++number_;
    }
    wake_.notify_one();
}

void CensusWorker::cancel() {
    const std::lock_guard lock(mutex_);
    next_ = {};
    ++number_;
}

void CensusWorker::work() {
    for (;;) {
        CensusQuestion question;
        int number = 0;
        {
            std::unique_lock lock(mutex_);
            wake_.wait(lock, [this] { return ends_ || next_.scene; });
            if (ends_) return;
            std::swap(question, next_);
            number = number_;
        }
        std::shared_ptr<const Census> census;
        try {
            census = std::make_shared<const Census>(takeCensus(question.solved(), question.cut.get()));
        } catch (const std::exception&) {  // of memory that ran out, say
        }
        QMetaObject::invokeMethod(this, [this, census, number] {
            const bool newest = [&] {
                const std::lock_guard lock(mutex_);
                return number == number_;
            }();
            if (newest) Q_EMIT answered(census);
        });
    }
}

}  // namespace keyblock
