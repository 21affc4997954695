// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Text above a figure: title, time, and the materials of the scene.
#pragma once

#include "solver/results/run_source.h"

#include <string>

namespace keyblock {

/// Title of the scene with the stage and time of the frame with this index, such as "Drift with D-bolts, stage release
/// at 0.212 s". In a static stage, the time is the pseudo-time. If `frame` is null, the title ends in "before the run".
std::string titleOf(const RunSource& run, std::optional<std::size_t> frame);

/// Text of a time in the stage with this index: "0.212 s" in a dynamic stage, the pseudo-time "0.21" in a static one.
std::string timeText(const Scene& scene, int stage, double time);

/// Like `timeText`, but times below 0.1 s in a dynamic stage are given in milliseconds: "3.95 ms".
std::string shortTimeText(const Scene& scene, int stage, double time);

/// One line that lists the rock, joints and bolts and gives the scale factor of the displacements.
std::string subtitleOf(const Scene& scene, double factor);

/// Type of analysis, and the integration scheme if a stage is dynamic: "plane strain · backward Euler scheme".
std::string analysisText(const Scene& scene);

}  // namespace keyblock
