// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/picture/captions.h"

#include "solver/results/result_names.h"
#include "solver/scene/enum_names.h"
#include "solver/scene/preset.h"
#include "solver/scene/units.h"
#include "ui/picture/ticks.h"

#include <algorithm>
#include <map>

namespace keyblock {

namespace {

constexpr std::size_t mostOfTitle = 90, mostOfStage = 46;  // letters
constexpr std::size_t mostNamed = 3;  // number of materials, joint materials or bolt kinds named in a caption

void join(std::string& text, const std::string& part, const char* between) {
    if (!part.empty()) text += (text.empty() ? "" : between) + part;
}

/// Shortens a text to at most `most` characters, so that the text after it stays on the page.
std::string shortened(const std::string& text, std::size_t most) {
    std::size_t letters = 0, at = 0;
    const auto begins = [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; };  // a letter in UTF-8
    for (; at < text.size(); ++at)
        if (begins(text[at]) && ++letters > most) break;
    return at == text.size() ? text : text.substr(0, at) + "…";
}

std::string rockText(const Scene& scene) {
    std::string text;
    for (std::size_t i = 0; i < scene.materials.size() && i < mostNamed; ++i) {
        const auto& [name, material] = scene.materials[i];
        join(text, name + " " + numberText(material.youngsModulus * perSi(namedUnit("GPa"))) + " GPa", ", ");
    }
    return text;
}

std::string jointText(const Scene& scene) {
    std::string text;
    for (std::size_t i = 0; i < scene.jointMaterials.size() && i < mostNamed; ++i) {
        const auto& [name, joint] = scene.jointMaterials[i];
        join(text, name + " φ " + numberText(joint.frictionAngle) + "°", ", ");
    }
    return text;
}

std::string boltText(const Scene& scene) {
    std::map<std::pair<std::string, std::string>, int> kinds;  // type and length
    for (const Bolt& bolt : scene.bolts)
        ++kinds[{bolt.type, numberText((bolt.head - bolt.farEnd).norm())}];
    std::string text;
    for (const auto& [kind, count] : kinds) {
        if (kinds.size() > mostNamed) return std::to_string(scene.bolts.size()) + " bolts";
        join(text, std::to_string(count) + " " + kind.first + " of " + kind.second + " m", ", ");
    }
    return text;
}

}  // namespace

std::string timeText(const Scene& scene, int stage, double time) {
    const bool dynamic = scene.stages[stage].kind == StageKind::Dynamic;
    return dynamic ? numberText(time) + " s" : numberText(time);
}

std::string shortTimeText(const Scene& scene, int stage, double time) {
    const bool dynamic = scene.stages[stage].kind == StageKind::Dynamic;
    return dynamic && time > 0.0 && time < 0.1 ? numberText(perSi(namedUnit("ms")) * time) + " ms" : timeText(scene, stage, time);
}

std::string titleOf(const RunSource& run, std::optional<std::size_t> frame) {
    const Scene& scene = run.scene();
    const std::string title = shortened(scene.title.empty() ? "Section" : scene.title, mostOfTitle);
    if (!frame) return title + ", before the run";
    const FrameHead& head = run.frames()[*frame];
    const std::string stage = shortened(stageTitle(scene, head.stage), mostOfStage);
    const std::string time = timeText(scene, head.stage, head.time);
    if (scene.stages[head.stage].kind == StageKind::Dynamic)
        return title + ", " + stage + " at " + time;
    return title + (head.time == 1.0 ? ", end of " + stage : ", " + stage + " at pseudo-time " + time);
}

std::string subtitleOf(const Scene& scene, double factor) {
    std::string text;
    join(text, rockText(scene), "; ");
    join(text, jointText(scene), "; ");
    join(text, boltText(scene), "; ");
    join(text, factor == 1.0 ? "drawn to scale" : "displacements scaled by " + numberText(factor), "; ");
    return text + ".";
}

std::string analysisText(const Scene& scene) {
    std::string text = scene.analysis.plane == Plane::Strain ? "plane strain" : "plane stress";
    if (std::any_of(scene.stages.begin(), scene.stages.end(),
                    [](const Stage& stage) { return stage.kind == StageKind::Dynamic; }))
        text += " · " + std::string(integrationLabels[static_cast<std::size_t>(scene.analysis.integration)]) + " scheme";
    return text + " · preset " + presetText(scene.analysis);
}

}  // namespace keyblock
