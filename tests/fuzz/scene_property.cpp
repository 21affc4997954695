// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/scene_property.h"

#include "solver/engine/setup/make_model.h"
#include "solver/files/scene/scene_file.h"

#include <algorithm>
#include <cmath>

namespace keyblock {
namespace {

std::string brokenAnswer(const SceneReading& reading) {
    const bool error = std::any_of(reading.problems.begin(), reading.problems.end(),
                                   [](const Problem& problem) { return problem.severity == Severity::Error; });
    if (error == reading.scene.has_value()) return error ? "a scene beside an error" : "neither a scene nor an error";
    for (const Problem& problem : reading.problems) {
        if (problem.message.empty()) return "a problem without a message at " + problem.pointer;
        if (problem.severity == Severity::Error && problem.remedy.empty())
            return "an error without a remedy: " + problem.message;
    }
    return {};
}

std::string brokenModel(const Model& model) {
    for (const BlockModel& block : model.blocks)
        if (!(block.area > 0.0) || !block.massMatrix.allFinite() || !block.elasticity.allFinite())
            return "block " + block.name + " has no finite mass or stiffness";
    for (const BoltModel& bolt : model.bolts)
        for (const BoltElement& element : bolt.elements)
            if (!(element.length > 0.0)) return "bolt " + bolt.name + " has an element without length";
    return {};
}

}  // namespace

std::string brokenSceneProperty(std::string_view bytes) {
    const SceneReading reading = readSceneText(bytes, "scene");
    if (std::string broken = brokenAnswer(reading); !broken.empty() || !reading.scene) return broken;
    const std::string text = wholeSceneText(*reading.scene);
    const SceneReading again = readSceneText(text, "written");
    if (!again.scene) return "not read back: " + (again.problems.empty() ? "" : oneLine(again.problems.front()));
    if (!(*again.scene == *reading.scene)) return "read back as another scene:\n" + text;
    return reading.scene->blocks.empty() ? std::string() : brokenModel(makeModel(*reading.scene));
}

}  // namespace keyblock
