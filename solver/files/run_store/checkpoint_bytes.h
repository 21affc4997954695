// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A run's checkpoint as bytes. The build's name says who may read them: another
// build may have other members, and other arithmetic.
#pragma once

#include "solver/run/checkpoint.h"

#include <optional>
#include <string>
#include <string_view>

namespace keyblock {

std::string bytesOf(const Checkpoint& checkpoint);

/// Null when the bytes are too few or too many for a checkpoint.
std::optional<Checkpoint> checkpointOf(std::string_view bytes);

/// Names this build of the mechanics: its id after the version.
std::string buildName();

}  // namespace keyblock
