// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Frames of a store one at a time, also while a run still writes it. Each reading
// opens the store for itself and sees all that was committed until then, so that no
// reader keeps the writer from folding its write-ahead file in.
#pragma once

#include "solver/results/results.h"
#include "solver/scene/scene.h"

#include <cstddef>
#include <filesystem>
#include <memory>

namespace keyblock {

class StoredFrames {
public:
    /// \param solved the store's scene as it was solved, i.e. cut; `blocks` rows has a frame.
    StoredFrames(std::filesystem::path path, std::shared_ptr<const Scene> solved, std::size_t blocks);

    /// From any thread. \throws CannotRead where there is no such frame yet, and for a damaged store.
    Frame frame(std::size_t index) const;

private:
    std::filesystem::path path_;
    std::shared_ptr<const Scene> solved_;
    std::size_t blocks_;
};

}  // namespace keyblock
