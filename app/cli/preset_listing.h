// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Text of the numerical settings of a scene: the preset, and what it, the scene and the
// command line each set.
#pragma once

#include "solver/scene/preset.h"

#include <span>
#include <string>
#include <string_view>

namespace keyblock::cli {

/// `preset`, `scene` or `--set`: where a setting comes from. \param overrides path=value, as given on the command line.
std::string_view originOf(const SettingInUse& setting, std::span<const std::string> overrides);

/// The preset, a line for each setting that it determines, and what the scene gives instead of leaving it to the preset.
std::string presetLines(const Scene& scene, std::span<const std::string> overrides);

}  // namespace keyblock::cli
