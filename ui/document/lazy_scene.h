// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A lazily loaded scene: of a thousand recovered undo steps, the user looks at only a
// few.
#pragma once

#include "solver/scene/scene.h"

#include <functional>
#include <memory>
#include <utility>

namespace keyblock {

class LazyScene {
public:
    explicit LazyScene(std::shared_ptr<const Scene> scene) : scene_(std::move(scene)) {}
    explicit LazyScene(std::function<std::shared_ptr<const Scene>()> read) : read_(std::move(read)) {}

    /// Reads the scene at the first call; null if it cannot be read.
    const std::shared_ptr<const Scene>& get() const {
        if (scene_ || !read_) return scene_;
        scene_ = read_();
        read_ = nullptr;
        return scene_;
    }

    /// The scene if it has been read already; otherwise null.
    const std::shared_ptr<const Scene>& known() const { return scene_; }

private:
    mutable std::shared_ptr<const Scene> scene_;
    mutable std::function<std::shared_ptr<const Scene>()> read_;
};

}  // namespace keyblock
