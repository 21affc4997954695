// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a list of runs shows of each, read without its scene, which may take seconds
// to cut.
#pragma once

#include "solver/results/results.h"

#include <filesystem>
#include <optional>
#include <string>

namespace keyblock {

struct RunSummary {
    std::string sceneHash;  // as `sceneHash(scene)`
    std::string programVersion;
    long frames = 0, events = 0;
    int stages = 0;  // begun
    std::string stage;  // name of the last that was begun
    std::optional<Outcome> outcome;  // of that; none: it never ended
    std::string message;  // of that
    bool resumable = false;  // it can be resumed by this build of the program
};

/// \throws CannotRead for what is missing, no run store, of another version or damaged.
RunSummary runSummary(const std::filesystem::path& store);

}  // namespace keyblock
