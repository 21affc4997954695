// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/edit/object_references.h"

#include "solver/scene/pointer.h"

#include <algorithm>
#include <string_view>

namespace keyblock {
namespace {

struct KindRow {
    Named kind;
    std::string_view list;
};
constexpr KindRow kindRows[] = {
    {Named::Material, "/materials"}, {Named::JointMaterial, "/joint_materials"}, {Named::Region, "/regions"},
    {Named::Tunnel, "/tunnels"}, {Named::Block, "/blocks"}, {Named::Bolt, "/bolts"},
    {Named::Pattern, "/bolt_patterns"}, {Named::BoltType, "/bolt_types"}, {Named::Joint, "/joints"},
    {Named::JointSet, "/joint_sets"}, {Named::Monitor, "/monitors"}};

template <typename Items>
std::vector<std::string> namesIn(const Items& items) {
    std::vector<std::string> names;
    for (const auto& item : items)
        if constexpr (requires { item.first; })
            names.push_back(item.first);
        else
            names.push_back(item.name);
    return names;
}

bool has(const std::vector<std::string>& names, std::string_view name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

/// Collects references while the scene is traversed.
class ReferenceCollector {
public:
    explicit ReferenceCollector(Scene& scene) : scene_(scene) {}

    std::vector<Reference> collect() {
        rock();
        section();
        support();
        for (std::size_t i = 0; i < scene_.stages.size(); ++i) stage(scene_.stages[i], under("/stages", i));
        watch();
        return std::move(found_);
    }

private:
    void add(Named kind, std::string pointer, std::string& text, WhenGone whenGone) {
        add(kind, std::move(pointer), text, 0, text.size(), whenGone);
    }
    void add(Named kind, std::string pointer, std::string& text, std::size_t at, std::size_t length, WhenGone gone) {
        if (length > 0) found_.push_back({kind, std::move(pointer), &text, at, length, gone});
    }
    void add(Named kind, std::string pointer, std::optional<std::string>& text) {
        if (text) add(kind, std::move(pointer), *text, WhenGone::Null);
    }

    void rock() {
        for (std::size_t i = 0; i < scene_.blocks.size(); ++i) {
            const std::string pointer = under("/blocks", i);
            add(Named::Material, under(pointer, "material"), scene_.blocks[i].material, WhenGone::Stays);
            add(Named::JointMaterial, under(pointer, "joint_material"), scene_.blocks[i].jointMaterial);
        }
        if (!scene_.domain) return;
        add(Named::Material, "/domain/material", scene_.domain->material, WhenGone::Stays);
        add(Named::JointMaterial, "/domain/joint_material", scene_.domain->jointMaterial);
    }

    void section() {
        for (std::size_t i = 0; i < scene_.joints.size(); ++i)
            add(Named::JointMaterial, under(under("/joints", i), "joint_material"), scene_.joints[i].jointMaterial);
        for (std::size_t i = 0; i < scene_.jointSets.size(); ++i) {
            const std::string pointer = under("/joint_sets", i);
            add(Named::JointMaterial, under(pointer, "joint_material"), scene_.jointSets[i].jointMaterial);
            add(Named::Region, under(pointer, "region"), scene_.jointSets[i].region);
        }
        if (!scene_.voronoi) return;
        add(Named::Region, "/voronoi/region", scene_.voronoi->region);
        add(Named::JointMaterial, "/voronoi/joint_material", scene_.voronoi->jointMaterial);
    }

    void support() {
        for (BoltType& type : scene_.boltTypes)
            if (!type.builtIn)
                add(Named::BoltType, under(under("/bolt_types", type.name), "like"), type.like, WhenGone::Null);
        for (std::size_t i = 0; i < scene_.bolts.size(); ++i)
            add(Named::BoltType, under(under("/bolts", i), "type"), scene_.bolts[i].type, WhenGone::Stays);
        for (std::size_t i = 0; i < scene_.boltPatterns.size(); ++i) {
            const std::string pointer = under("/bolt_patterns", i);
            add(Named::BoltType, under(pointer, "type"), scene_.boltPatterns[i].type, WhenGone::Stays);
            add(Named::Tunnel, under(pointer, "tunnel"), scene_.boltPatterns[i].tunnel, WhenGone::Owner);
        }
    }

    void stage(Stage& stage, const std::string& pointer) {
        const std::vector<std::string> tunnels = namesIn(scene_.tunnels);
        for (std::size_t i = 0; i < stage.excavate.size(); ++i) {
            const Named kind = has(tunnels, stage.excavate[i]) ? Named::Tunnel : Named::Block;
            add(kind, under(under(pointer, "excavate"), i), stage.excavate[i], WhenGone::Entry);
        }
        bolts(stage.install, under(pointer, "install"));
        bolts(stage.remove, under(pointer, "remove"));
        for (std::size_t i = 0; i < stage.set.size(); ++i)
            add(Named::JointMaterial, under(under(under(pointer, "set"), i), "joint_material"),
                stage.set[i].jointMaterial, WhenGone::Owner);
        for (std::size_t i = 0; i < stage.dilations.size(); ++i) {
            std::string& joint = stage.dilations[i].joint;
            const Named kind = has(namesIn(scene_.joints), joint)      ? Named::Joint
                               : has(namesIn(scene_.jointSets), joint) ? Named::JointSet
                                                                       : Named::JointMaterial;
            add(kind, under(under(under(pointer, "dilations"), i), "joint"), joint, WhenGone::Owner);
        }
    }

    void bolts(std::vector<std::string>& names, const std::string& pointer) {
        for (std::size_t i = 0; i < names.size(); ++i) bolt(names[i], 0, under(pointer, i), WhenGone::Entry);
    }

    /// Adds the reference to a bolt, a pattern, or a bolt of a pattern (`P1.3`) whose name starts at `at`.
    void bolt(std::string& text, std::size_t at, const std::string& pointer, WhenGone whenGone) {
        const std::string_view name = std::string_view(text).substr(at);
        Named kind = Named::Bolt;
        std::size_t length = name.size();
        if (!has(namesIn(scene_.bolts), name)) {
            const std::size_t pattern = longestName(name, namesIn(scene_.boltPatterns));
            if (pattern > 0) kind = Named::Pattern, length = pattern;
        }
        add(kind, pointer, text, at, length, whenGone);
    }

    /// Length of the longest name with which `text` starts, followed by the end or a dot; 0 if there is none.
    static std::size_t longestName(std::string_view text, const std::vector<std::string>& names) {
        std::size_t longest = 0;
        for (const std::string& name : names)
            if (text.starts_with(name) && (text.size() == name.size() || text[name.size()] == '.'))
                longest = std::max(longest, name.size());
        return longest;
    }

    void watch() {
        for (std::size_t i = 0; i < scene_.monitors.size(); ++i)
            if (scene_.monitors[i].bolt)
                bolt(*scene_.monitors[i].bolt, 0, under(under("/monitors", i), "bolt"), WhenGone::Owner);
        for (std::size_t i = 0; i < scene_.quantities.size(); ++i)
            quantity(scene_.quantities[i], under("/quantities", i), WhenGone::Entry);
        for (std::size_t i = 0; i < scene_.about.expected.size(); ++i)
            quantity(scene_.about.expected[i].quantity, under(under("/about/expected", i), "quantity"), WhenGone::Owner);
    }

    /// Adds the names in a quantity: `max NAME.quantity`, `last NAME` or `first KIND NAME`. The other quantities contain
    /// none.
    void quantity(std::string& text, const std::string& pointer, WhenGone whenGone) {
        if (text.starts_with("count ") || text.starts_with("order ")) return;
        std::size_t at = text.find(' ');
        if (at != std::string::npos && text.starts_with("first ")) at = text.find(' ', at + 1);
        if (at == std::string::npos) return;
        ++at;
        const std::string_view rest = std::string_view(text).substr(at);
        const std::size_t monitor = longestName(rest, namesIn(scene_.monitors));
        const std::size_t single = longestName(rest, namesIn(scene_.bolts));
        const std::size_t pattern = longestName(rest, namesIn(scene_.boltPatterns));
        const std::size_t longest = std::max({monitor, single, pattern});
        const Named kind = longest == monitor ? Named::Monitor : longest == single ? Named::Bolt : Named::Pattern;
        add(kind, pointer, text, at, longest, whenGone);
    }

    Scene& scene_;
    std::vector<Reference> found_;
};

}  // namespace

std::vector<Reference> referencesOf(Scene& scene) { return ReferenceCollector(scene).collect(); }

std::string listOf(Named kind) {
    const auto found = std::find_if(std::begin(kindRows), std::end(kindRows),
                                    [&](const KindRow& row) { return row.kind == kind; });
    return std::string(found->list);
}

bool kindOfList(std::string_view list, Named& kind) {
    for (const KindRow& row : kindRows)
        if (row.list == list) {
            kind = row.kind;
            return true;
        }
    return false;
}

std::vector<std::string> namesOfKind(const Scene& scene, Named kind) {
    switch (kind) {
        case Named::Material: return namesIn(scene.materials);
        case Named::JointMaterial: return namesIn(scene.jointMaterials);
        case Named::Region: return namesIn(scene.regions);
        case Named::Tunnel: return namesIn(scene.tunnels);
        case Named::Block: return namesIn(scene.blocks);
        case Named::Bolt: return namesIn(scene.bolts);
        case Named::Pattern: return namesIn(scene.boltPatterns);
        case Named::BoltType: return namesIn(scene.boltTypes);
        case Named::Joint: return namesIn(scene.joints);
        case Named::JointSet: return namesIn(scene.jointSets);
        case Named::Monitor: break;
    }
    return namesIn(scene.monitors);
}

}  // namespace keyblock
