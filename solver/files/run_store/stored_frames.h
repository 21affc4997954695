// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads frames of a store one at a time, even while a run is writing it. The store is
// opened again for each frame and shows everything committed so far, so that no reader
// prevents the writer from merging its write-ahead file.
#pragma once

#include "solver/results/results.h"
#include "solver/scene/scene.h"

#include <cstddef>
#include <filesystem>
#include <memory>
#include <vector>

namespace keyblock {

class StoredFrames {
public:
    /// \param solved the scene as solved, i.e. after cutting.
    StoredFrames(std::filesystem::path path, std::shared_ptr<const Scene> solved);

    /// Reads a frame; may be called from any thread.
    /// \throws CannotRead if the store has no such frame or is damaged.
    Frame frame(std::size_t index) const;

private:
    std::filesystem::path path_;
    std::shared_ptr<const Scene> solved_;
    std::vector<std::size_t> corners_;  // number for each block
};

}  // namespace keyblock
