// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The text above a picture: scene and time, and the materials of the scene.
#pragma once

#include "solver/results/run_source.h"

#include <string>

namespace keyblock {

/// "Drift with D-bolts, stage release at 0.212 s"; of a static stage its pseudo-time.
std::string titleOf(const RunSource& run, std::optional<std::size_t> frame);

/// A time of a stage: "0.212 s", or the pseudo-time "0.21" of a static one.
std::string timeText(const Scene& scene, int stage, double time);

/// The same in short form: "3.95 ms" for less than a tenth of a second.
std::string shortTimeText(const Scene& scene, int stage, double time);

/// Rock, joints and bolts on one line, and the scale of displacements.
std::string subtitleOf(const Scene& scene, double factor);

/// "plane strain · backward-euler"
std::string analysisText(const Scene& scene);

}  // namespace keyblock
