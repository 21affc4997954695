// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numerical settings for a purpose. A preset is a list of settings of `analysis` in a
// file of resources/presets; it applies to the settings that the scene leaves out.
#pragma once

#include "solver/scene/field.h"
#include "solver/scene/scene.h"

#include <string>
#include <string_view>
#include <vector>

namespace keyblock {

/// The numerical settings that a run uses: those of the scene, otherwise those of its preset.
struct Numerics {
    ContactMethod contact = ContactMethod::Penalty;
    double penaltyRatio = 0.0, tolerance = 0.0;
    int maxPasses = 0;
    double sleepTolerance = 0.0;
    double timeStepFactor = 0.0, divisionsFactor = 0.0;
};

Numerics numericsOf(const Analysis& analysis);

/// A setting that presets determine.
struct SettingInUse {
    const Field* field = nullptr;  // row of `analysis`
    FieldValue value, ofPreset;  // used by a run, and according to the preset
    bool given = false;  // by the scene
};

/// All settings that presets determine, in the order of the field table.
std::vector<SettingInUse> settingsInUse(const Analysis& analysis);

/// The name of the preset and how many of its settings the scene changes, e.g. "engineering, 2 settings changed".
std::string presetText(const Analysis& analysis);

/// What the preset is for.
std::string_view presetHelp(Preset preset);

/// What every result made with the preset must say; empty: nothing.
std::string_view presetWarning(Preset preset);

}  // namespace keyblock
