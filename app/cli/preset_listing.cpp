// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/preset_listing.h"

#include "app/cli/text_table.h"
#include "solver/scene/number_text.h"

#include <algorithm>

namespace keyblock::cli {

namespace {

std::string valueText(const FieldValue& value) {
    const auto* word = std::get_if<std::string>(&value);
    return word ? *word : shortest(std::get<double>(value));
}

/// Overrides write the path with dots, with slashes or as a JSON pointer.
bool sets(const std::string& override, std::string_view key) {
    std::string path = override.substr(0, override.find('='));
    std::replace(path.begin(), path.end(), '/', '.');
    if (path.starts_with('.')) path.erase(0, 1);
    return path == "analysis." + std::string(key);
}

std::string counted(std::ptrdiff_t count, const std::string& what) {
    return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

/// Time steps and divisions that the scene gives: the factors of the preset do not apply to them.
std::string givenLine(const Scene& scene) {
    const auto steps = std::count_if(scene.stages.begin(), scene.stages.end(),
                                     [](const Stage& stage) { return stage.timeStep.has_value(); });
    const auto isDivided = [](const auto& bolts) { return bolts.divisions.has_value(); };
    const auto bolts = std::count_if(scene.bolts.begin(), scene.bolts.end(), isDivided);
    const auto patterns = std::count_if(scene.boltPatterns.begin(), scene.boltPatterns.end(), isDivided);
    std::string text;
    const auto add = [&](const std::string& part) { text += (text.empty() ? "" : " and ") + part; };
    if (steps > 0) add("the time step of " + counted(steps, "stage"));
    if (bolts > 0) add("the divisions of " + counted(bolts, "bolt"));
    if (patterns > 0) add("the divisions of " + counted(patterns, "bolt pattern"));
    return text.empty() ? "" : "  the scene gives " + text + ", which the preset leaves as they are\n";
}

}  // namespace

std::string_view originOf(const SettingInUse& setting, std::span<const std::string> overrides) {
    if (!setting.given) return "preset";
    const bool isSet = std::any_of(overrides.begin(), overrides.end(),
                                   [&](const std::string& override) { return sets(override, setting.field->key); });
    return isSet ? "--set" : "scene";
}

std::string presetLines(const Scene& scene, std::span<const std::string> overrides) {
    std::vector<TextRow> rows;
    for (const SettingInUse& setting : settingsInUse(scene.analysis))
        rows.push_back({"  " + std::string(setting.field->key), valueText(setting.value),
                        "from " + std::string(originOf(setting, overrides))});
    return "preset " + presetText(scene.analysis) + "\n" +
           textTable({{"  setting", Align::Left, 20}, {"value"}, {""}}, rows) + givenLine(scene);
}

}  // namespace keyblock::cli
