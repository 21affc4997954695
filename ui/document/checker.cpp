// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/checker.h"

#include <exception>
#include <optional>

namespace keyblock {

// Whatever a check throws (memory that ran out, say) is a problem to be told, never the end of the program.
std::shared_ptr<const Checked> checkedOf(const std::shared_ptr<const Scene>& scene) {
    auto checked = std::make_shared<Checked>();
    checked->scene = scene;
    try {
        std::optional<SceneCut> cut;
        checked->problems = checkScene(*scene, &cut);
        if (cut) checked->cut = std::make_shared<const SceneCut>(std::move(*cut));
        const Scene& solved = checked->cut ? checked->cut->scene : *scene;
        if (!hasErrors(checked->problems) && !solved.blocks.empty())
            checked->picture = std::make_shared<const SectionPicture>(drawingPicture(solved));
    } catch (const std::exception& error) {
        checked->problems.push_back({Severity::Error, {}, 0, {}, std::string("the check failed: ") + error.what(),
                                     "undo the last edit, or make the scene smaller"});
    }
    return checked;
}

Checker::Checker(QObject* parent) : QObject(parent), thread_([this] { work(); }) {}

Checker::~Checker() {
    {
        const std::lock_guard lock(mutex_);
        ends_ = true;
    }
    wake_.notify_one();
    thread_.join();
}

void Checker::check(std::shared_ptr<const Scene> scene) {
    {
        const std::lock_guard lock(mutex_);
        next_ = std::move(scene);
    }
    wake_.notify_one();
}

void Checker::work() {
    for (;;) {
        std::shared_ptr<const Scene> scene;
        {
            std::unique_lock lock(mutex_);
            wake_.wait(lock, [this] { return ends_ || next_; });
            if (ends_) return;
            scene.swap(next_);
        }
        const std::shared_ptr<const Checked> checked = checkedOf(scene);
        QMetaObject::invokeMethod(this, [this, checked] { Q_EMIT finished(checked); }, Qt::QueuedConnection);
    }
}

}  // namespace keyblock
