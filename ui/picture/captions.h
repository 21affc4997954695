// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Text above a figure: title, time, and the materials of the scene.
#pragma once

#include "solver/results/run_source.h"

#include <string>

namespace keyblock {

/// Title that includes the stage and time of a frame, such as "Drift with D-bolts, stage release at 0.212 s"; for a
/// static stage, the time is its pseudo-time.
std::string titleOf(const RunSource& run, std::optional<std::size_t> frame);

/// A time within a stage: "0.212 s" for a dynamic stage, the pseudo-time "0.21" for a static one.
std::string timeText(const Scene& scene, int stage, double time);

/// Like `timeText`, but in milliseconds below a tenth of a second: "3.95 ms".
std::string shortTimeText(const Scene& scene, int stage, double time);

/// One line that lists the rock, joints and bolts and gives the scale factor of the displacements.
std::string subtitleOf(const Scene& scene, double factor);

/// Type of analysis, and the integration scheme if a stage is dynamic: "plane strain · backward Euler scheme".
std::string analysisText(const Scene& scene);

}  // namespace keyblock
