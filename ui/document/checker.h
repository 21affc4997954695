// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Checks and cuts scenes on a thread of its own, always the newest one: what was
// handed in meanwhile and overtaken is never looked at.
#pragma once

#include "solver/scene/check.h"
#include "ui/document/drawing.h"

#include <QObject>

#include <condition_variable>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

namespace keyblock {

/// What a check found.
struct Checked {
    std::shared_ptr<const Scene> scene;
    std::vector<Problem> problems;
    std::shared_ptr<const SceneCut> cut;  // null: errors keep it from being cut, or it needs none
    std::shared_ptr<const SectionPicture> picture;  // as drawn; null: errors, or no blocks
};

/// Checks, cuts and draws a scene here and now; whatever goes wrong is a problem.
std::shared_ptr<const Checked> checkedOf(const std::shared_ptr<const Scene>& scene);

class Checker : public QObject {
    Q_OBJECT

public:
    explicit Checker(QObject* parent = nullptr);
    ~Checker() override;

    /// Looks at the scene as soon as the one before is done.
    void check(std::shared_ptr<const Scene> scene);

Q_SIGNALS:
    void finished(std::shared_ptr<const keyblock::Checked> checked);  // in the thread of this object

private:
    void work();

    std::mutex mutex_;
    std::condition_variable wake_;
    std::shared_ptr<const Scene> next_;
    bool ends_ = false;
    std::thread thread_;
};

}  // namespace keyblock
