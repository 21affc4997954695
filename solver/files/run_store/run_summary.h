// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Summary of a run store for a list of runs, read without the scene, which may take
// seconds to cut.
#pragma once

#include "solver/results/results.h"

#include <filesystem>
#include <optional>
#include <string>

namespace keyblock {

struct RunSummary {
    std::string sceneHash;  // `sceneHash(scene)` of its scene
    std::string programVersion;
    long frames = 0, events = 0;
    int stages = 0;  // number of stages begun
    std::string stage;  // name of the last stage begun
    std::optional<Outcome> outcome;  // outcome of that stage; none if it never ended
    std::string message;  // message of that stage
    bool resumable = false;  // whether this build of the program can resume the run
};

/// Reads the summary of a run store.
/// \throws CannotRead if the file is missing, is not a run store, is of another version or is damaged.
RunSummary runSummary(const std::filesystem::path& store);

}  // namespace keyblock
