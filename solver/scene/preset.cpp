// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/scene/preset.h"

#include "solver/scene/enum_names.h"
#include "solver/scene/preset_data.h"
#include "solver/scene/structures.h"

#include <algorithm>
#include <array>

namespace keyblock {

namespace {

const PresetData& dataOf(Preset preset) { return presetData()[static_cast<std::size_t>(preset)]; }

bool isSet(const PresetData& data, std::string_view key) {
    return std::any_of(data.settings.begin(), data.settings.end(),
                       [&](const auto& setting) { return setting.first == key; });
}

void put(Analysis& analysis, const PresetData& data) {
    const Structure& structure = structureOf(&analysis);
    for (const auto& [key, value] : data.settings)
        if (const Field* field = findField(structure, key)) field->set(&analysis, value);
}

/// Settings of a preset: those of its file on top of those of `engineering`, which has all of them.
const Analysis& settingsOf(Preset preset) {
    static const auto all = [] {
        std::array<Analysis, presetWords.size()> made;
        for (std::size_t i = 0; i < made.size(); ++i) {
            put(made[i], dataOf(Preset::Engineering));
            put(made[i], presetData()[i]);
        }
        return made;
    }();
    return all[static_cast<std::size_t>(preset)];
}

}  // namespace

Numerics numericsOf(const Analysis& analysis) {
    const Analysis& preset = settingsOf(analysis.preset);
    const auto used = [&](auto member) { return (analysis.*member).value_or((preset.*member).value()); };
    return {used(&Analysis::contact),        used(&Analysis::penaltyRatio),   used(&Analysis::tolerance),
            used(&Analysis::maxPasses),      used(&Analysis::sleepTolerance), used(&Analysis::timeStepFactor),
            used(&Analysis::divisionsFactor)};
}

std::vector<SettingInUse> settingsInUse(const Analysis& analysis) {
    const Analysis& preset = settingsOf(analysis.preset);
    std::vector<SettingInUse> settings;
    for (const Field& field : structureOf(&analysis).fields) {
        if (!isSet(dataOf(Preset::Engineering), field.key)) continue;
        SettingInUse setting;
        setting.field = &field;
        setting.ofPreset = setting.field->get(&preset);
        setting.value = setting.field->get(&analysis);
        setting.given = !std::holds_alternative<std::monostate>(setting.value);
        if (!setting.given) setting.value = setting.ofPreset;
        settings.push_back(std::move(setting));
    }
    return settings;
}

std::string presetText(const Analysis& analysis) {
    const std::vector<SettingInUse> settings = settingsInUse(analysis);
    const auto changed = std::count_if(settings.begin(), settings.end(),
                                       [](const SettingInUse& setting) { return setting.value != setting.ofPreset; });
    std::string text(presetWords[static_cast<std::size_t>(analysis.preset)]);
    if (changed > 0) text += ", " + std::to_string(changed) + (changed == 1 ? " setting" : " settings") + " changed";
    return text;
}

std::string_view presetHelp(Preset preset) { return dataOf(preset).help; }

std::string_view presetWarning(Preset preset) { return dataOf(preset).warning; }

}  // namespace keyblock
