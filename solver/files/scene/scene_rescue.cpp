// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Objects that lack required data are removed from the tree and the rest is read
// again, until nothing is missing. Each round removes at least one object, and the
// size of a tree is limited, so the loop ends.
#include "solver/files/scene/scene_rescue.h"

#include "solver/files/json/field_json.h"
#include "solver/files/json/json_tree.h"
#include "solver/files/scene/scene_from_tree.h"
#include "solver/files/scene/scene_version.h"
#include "solver/scene/field.h"

#include <set>

namespace keyblock {

namespace {

std::string parentOf(const std::string& pointer) { return pointer.substr(0, pointer.rfind('/')); }

// Position of the field that contains an error; for a point of an outline, that of the outline.
std::string placeOfField(std::string pointer) {
    for (std::string parent = parentOf(pointer); !parent.empty(); parent = parentOf(parent))
        if (const Field* field = sceneFieldAt(parent); field && !hasChildren(*field)) pointer = parent;
    return pointer;
}

// The object that cannot be used because of this error; empty if there is none, or if it is the whole scene.
std::string unusableBy(const Problem& error, const JsonNode& root) {
    const std::string place = placeOfField(error.pointer);
    const JsonNode* node = nodeAt(root, place);
    const Field* field = sceneFieldAt(place);
    if (!field) return node && !std::holds_alternative<JsonObject>(node->value) ? place : std::string();
    if (!field->required) return {};
    std::vector<Problem> ignored;
    if (node && (hasChildren(*field) || valueFromJson(*field, *node, place, ignored))) return {};
    return parentOf(place);
}

// Removes the doomed values from the tree.
void sweep(JsonNode& node, const std::set<const JsonNode*>& doomed) {
    if (auto* list = std::get_if<JsonList>(&node.value)) {
        JsonList kept;
        for (JsonNode& item : *list)
            if (!doomed.contains(&item)) {
                sweep(item, doomed);
                kept.push_back(std::move(item));
            }
        *list = std::move(kept);
    } else if (auto* object = std::get_if<JsonObject>(&node.value)) {
        JsonObject kept;
        for (JsonMember& member : *object)
            if (!doomed.contains(&member.node)) {
                sweep(member.node, doomed);
                kept.push_back(std::move(member));
            }
        *object = std::move(kept);
    }
}

std::set<std::string> unusable(const JsonNode& root, const std::vector<Problem>& problems) {
    std::set<std::string> pointers;
    for (const Problem& problem : problems)
        if (problem.severity == Severity::Error && !problem.pointer.empty())
            if (std::string pointer = unusableBy(problem, root); !pointer.empty()) pointers.insert(std::move(pointer));
    return pointers;
}

}  // namespace

SceneRescue rescueSceneText(std::string_view text, const std::string& name, const std::filesystem::path& folder) {
    SceneRescue rescue;
    JsonReading json = readJson(text);
    rescue.problems = std::move(json.problems);
    rescue.brokeOff = !json.root && json.before;
    std::optional<JsonNode> root = json.root ? std::move(json.root) : std::move(json.before);
    for (bool isFirst = true; root && bringUpToDate(*root, rescue.problems); isFirst = false) {
        std::vector<Problem> found, lost;
        Scene scene = sceneOfTree(*root, folder, found, lost);
        if (isFirst) {
            for (const Problem& problem : found) addProblem(rescue.problems, problem);
            rescue.isWhole = !hasErrors(rescue.problems);
            for (const Problem& problem : lost) addProblem(rescue.problems, problem);
        }
        const std::set<std::string> lacking = unusable(*root, found);
        if (lacking.empty()) {
            rescue.scene = std::move(scene);
            break;
        }
        std::set<const JsonNode*> doomed;
        for (const std::string& pointer : lacking)
            if (const JsonNode* node = nodeAt(*root, pointer)) doomed.insert(node);
        sweep(*root, doomed);
        // In later rounds, lists have lost items, so positions in them would refer to other objects.
        if (isFirst) rescue.leftOut.assign(lacking.begin(), lacking.end());
    }
    for (Problem& problem : rescue.problems) problem.file = name;
    return rescue;
}

}  // namespace keyblock
