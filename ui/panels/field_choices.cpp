// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/field_choices.h"

#include "solver/files/scene/bolt_library.h"
#include "solver/scene/enum_names.h"
#include "ui/edit/scene_objects.h"

#include <algorithm>

namespace keyblock {

namespace {

using Names = std::vector<std::string>;

template <typename Items>
void append(Names& names, const Items& items) {
    for (const auto& item : items)
        if constexpr (requires { item.first; })
            names.push_back(item.first);
        else if (!item.name.empty())
            names.push_back(item.name);
}

template <typename... Lists>
Names namesIn(const Lists&... lists) {
    Names names;
    (append(names, lists), ...);
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
    Names names = namesIn(scene.bolts);
    for (const ScenePattern& pattern : scene.boltPatterns) {
        const std::size_t count = boltsOfPattern(scene, pattern).size();
        for (std::size_t i = 1; i <= count; ++i) names.push_back(pattern.name + "." + std::to_string(i));
    }
    return names;
}

}  // namespace

std::optional<Names> choicesOf(const Scene& scene, const Structure& structure, const Field& field) {
    const std::string_view key = field.key;
    if (key == "material") return namesIn(scene.materials);
    if (key == "joint_material") return namesIn(scene.jointMaterials);
    if (key == "region") return namesIn(scene.regions);
    if (key == "tunnel") return namesIn(scene.tunnels);
    if (key == "like" || (key == "type" && field.kind == FieldKind::Text)) return boltTypes(scene);
    if (key == "bolt") return bolts(scene);
    if (structure.name == "dilation" && key == "joint")
        return namesIn(scene.joints, scene.jointSets, scene.jointMaterials);
    if (key == "excavate") return namesIn(scene.tunnels, scene.blocks);
    if (key == "install" || key == "remove") return namesIn(scene.boltPatterns, scene.bolts);
    if (key == "viscous_boundaries") return Names(boundarySideWords.begin(), boundarySideWords.end());
    return std::nullopt;
}

}  // namespace keyblock
