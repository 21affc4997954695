// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Takes the census of a scene on a thread of its own, of the newest one that was
// asked for; what was overtaken is never looked at, or its answer dropped.
#pragma once

#include "solver/run/census.h"

#include <QObject>

#include <condition_variable>
#include <memory>
#include <mutex>
#include <thread>

namespace keyblock {

/// What is counted: a scene as it is solved, and its cut where it has one.
struct CensusQuestion {
    std::shared_ptr<const Scene> scene;  // the document's
    std::shared_ptr<const SceneCut> cut;  // null: the scene needs none

    const Scene& solved() const { return cut ? cut->scene : *scene; }
};

class CensusWorker : public QObject {
    Q_OBJECT

public:
    explicit CensusWorker(QObject* parent = nullptr);
    ~CensusWorker() override;

    /// \pre the scene was checked without errors and has blocks.
    void ask(CensusQuestion question);

    /// Drops what was asked and is not answered yet.
    void cancel();

Q_SIGNALS:
    /// In the thread of this object; of the newest question only. Null: it could not be taken.
    void answered(std::shared_ptr<const keyblock::Census> census);

private:
    void work();

    std::mutex mutex_;
    std::condition_variable wake_;
    CensusQuestion next_;
    int number_ = 0;  // of the newest question
    bool ends_ = false;
    std::thread thread_;
};

}  // namespace keyblock
