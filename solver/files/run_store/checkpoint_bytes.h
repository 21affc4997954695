// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A run's checkpoint as bytes. Only the build that wrote them may read them, because
// another build may have different members and different arithmetic.
#pragma once

#include "solver/run/checkpoint.h"

#include <optional>
#include <string>
#include <string_view>

namespace keyblock {

std::string bytesOf(const Checkpoint& checkpoint);

/// Decodes a checkpoint; none if there are too few or too many bytes.
std::optional<Checkpoint> checkpointOf(std::string_view bytes);

/// Name of this build: the program version followed by the build id.
std::string buildName();

}  // namespace keyblock
