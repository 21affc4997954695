// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A scene that is read only when somebody wants to see it: of a thousand steps that
// are recovered a person looks at a few.
#pragma once

#include "solver/scene/scene.h"

#include <functional>
#include <memory>
#include <utility>

namespace keyblock {

class LateScene {
public:
    explicit LateScene(std::shared_ptr<const Scene> scene) : scene_(std::move(scene)) {}
    explicit LateScene(std::function<std::shared_ptr<const Scene>()> read) : read_(std::move(read)) {}

    /// Reads it the first time; null where it cannot be read.
    const std::shared_ptr<const Scene>& get() const {
        if (scene_ || !read_) return scene_;
        scene_ = read_();
        read_ = nullptr;
        return scene_;
    }

    /// Null while nobody wanted it.
    const std::shared_ptr<const Scene>& known() const { return scene_; }

private:
    mutable std::shared_ptr<const Scene> scene_;
    mutable std::function<std::shared_ptr<const Scene>()> read_;
};

}  // namespace keyblock
