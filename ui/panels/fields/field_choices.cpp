// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/fields/field_choices.h"

#include "solver/files/scene/bolt_library.h"
#include "ui/edit/scene_objects.h"

#include <algorithm>
#include <iterator>

namespace keyblock {

namespace {

using Names = std::vector<std::string>;

/// Names of the entries of a list or map of the scene.
Names entriesOf(const Scene& scene, const Field& list) {
    const Children& children = list.children;
    const Field* nameField = findField(children.structure(), "name");
    Names names;
    for (std::size_t i = 0; i < children.count(&scene); ++i) {
        const bool isMap = list.kind == FieldKind::Map;
        std::string name = isMap ? std::string(children.name(&scene, i))
                                 : std::get<std::string>(nameField->get(children.item(&scene, i)));
        if (isMap || !name.empty()) names.push_back(std::move(name));
    }
    return names;
}

/// The scene's own types first, then the built-in ones.
Names boltTypes(const Scene& scene) {
    Names names;
    for (const BoltType& type : scene.boltTypes)
        if (!type.builtIn) names.push_back(type.name);
    for (const BoltType& type : builtInBoltTypes())
        if (!std::ranges::count(names, type.name)) names.push_back(type.name);
    return names;
}

/// Single bolts, then the bolts of patterns: `P1.1`, `P1.2`, …
Names bolts(const Scene& scene) {
    Names names;
    for (const Bolt& bolt : scene.bolts)
        if (!bolt.name.empty()) names.push_back(bolt.name);
    for (const ScenePattern& pattern : scene.boltPatterns) {
        const std::size_t count = boltsOfPattern(scene, pattern).size();
        for (std::size_t i = 1; i <= count; ++i) names.push_back(pattern.name + "." + std::to_string(i));
    }
    return names;
}

}  // namespace

std::optional<Names> choicesOf(const Scene& scene, const Field& field) {
    if (field.kind == FieldKind::TextList && !field.words.empty()) return Names(field.words.begin(), field.words.end());
    if (field.names.empty()) return std::nullopt;
    if (field.namesSingleBolts) return bolts(scene);
    Names names;
    for (const std::string_view key : field.names) {
        const Field& list = *findField(sceneStructure(), key);
        const bool isOfTypes = &list.children.structure() == &boltTypeStructure();
        std::ranges::move(isOfTypes ? boltTypes(scene) : entriesOf(scene, list), std::back_inserter(names));
    }
    return names;
}

}  // namespace keyblock
