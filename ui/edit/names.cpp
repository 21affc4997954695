// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/edit/names.h"

#include "solver/files/scene/bolt_library.h"
#include "solver/scene/lookup.h"
#include "solver/scene/pointer.h"
#include "solver/scene/suggest.h"
#include "ui/edit/locate.h"
#include "ui/edit/object_references.h"

#include <algorithm>
#include <charconv>

namespace keyblock {
namespace {

struct Style {
    std::string_view list;
    std::string_view stem;  // of new names
};
constexpr Style styles[] = {
    {"/materials", "rock "}, {"/joint_materials", "joint "}, {"/joints", "J"}, {"/joint_sets", "J"},
    {"/regions", "region "}, {"/tunnels", "tunnel "}, {"/blocks", "block "}, {"/bolts", "B"},
    {"/bolt_patterns", "P"}, {"/bolt_types", "bolt type "}, {"/stages", "stage "}, {"/monitors", "M"}};

std::string_view stemOf(std::string_view list) {
    for (const Style& style : styles)
        if (style.list == list) return style.stem;
    return {};
}

template <typename Item>
void append(std::vector<std::string>& names, const std::vector<Item>& items) {
    for (const Item& item : items) names.push_back(item.name);
}

/// Names that a new name in the list must differ from: those in the list, and others that a stage could confuse with
/// it.
std::vector<std::string> namesBeside(const Scene& scene, std::string_view list) {
    std::vector<std::string> names;
    if (list == "/stages") {
        append(names, scene.stages);
        return names;
    }
    Named kind;
    if (!kindOfList(list, kind)) return names;
    names = namesOfKind(scene, kind);
    if (kind == Named::Bolt) append(names, scene.boltPatterns);
    if (kind == Named::Pattern) append(names, scene.bolts);
    if (kind == Named::Tunnel) append(names, scene.blocks);
    if (kind == Named::Block) append(names, scene.tunnels);
    if (kind == Named::Joint) append(names, scene.jointSets);
    if (kind == Named::JointSet) append(names, scene.joints);
    if (kind == Named::BoltType) append(names, builtInBoltTypes());
    return names;
}

/// The number after the stem; −1 if `name` is not the stem with a number.
long numberBehind(std::string_view stem, std::string_view name) {
    if (!name.starts_with(stem)) return -1;
    long number = -1;
    const char* begin = name.data() + stem.size();
    const char* last = name.data() + name.size();
    const auto [end, error] = std::from_chars(begin, last, number);
    return error == std::errc{} && end == last && begin != last && *begin != '-' ? number : -1;
}

std::string withName(std::string_view kind, std::string_view name) {
    if (name.empty() || name.starts_with(kind)) return std::string(name.empty() ? kind : name);  // for example tunnel 1
    return std::string(kind) + " " + std::string(name);
}

std::string numbered(std::string_view kind, const std::string& index) {
    return std::string(kind) + " " + std::to_string(std::atoi(index.c_str()) + 1);
}

std::string textOf(const Structure& structure, const void* object, std::string_view key) {
    const Field* field = findField(structure, key);
    if (!field || !field->get) return {};
    const FieldValue value = field->get(object);
    const auto* text = std::get_if<std::string>(&value);
    return text ? *text : std::string();
}

}  // namespace

std::string freeName(std::string_view stem, const std::vector<std::string>& taken) {
    long last = 0;
    for (const std::string& name : taken) last = std::max(last, numberBehind(stem, name));
    return std::string(stem) + std::to_string(last + 1);
}

std::string newName(const Scene& scene, std::string_view list) {
    const std::string_view stem = stemOf(list);
    if (list == "/stages") {  // the fourth stage is stage 4, regardless of the other names
        const std::string place = std::string(stem) + std::to_string(scene.stages.size() + 1);
        const std::vector<std::string> taken = namesBeside(scene, list);
        return std::find(taken.begin(), taken.end(), place) == taken.end() ? place : freeName(stem, taken);
    }
    return stem.empty() ? std::string() : freeName(stem, namesBeside(scene, list));
}

std::string nameOfCopy(const Scene& scene, std::string_view list, std::string_view name) {
    const std::vector<std::string> taken = namesBeside(scene, list);
    if (std::find(taken.begin(), taken.end(), name) == taken.end()) return std::string(name);
    const std::size_t digits = name.find_last_not_of("0123456789") + 1;
    const std::string stem(name.substr(0, digits));
    if (digits < name.size()) return freeName(stem, taken);
    const std::string next = freeName(stem + " ", taken);
    return numberBehind(stem + " ", next) == 1 ? stem + " 2" : next;
}

std::string nameAt(const Scene& scene, std::string_view pointer) {
    const auto place = locate(scene, pointer);
    if (!place || !place->field || !place->isObject()) return {};
    if (place->field->kind == FieldKind::Map) return std::string(place->field->children.name(place->owner, *place->entry));
    return textOf(place->objectStructure(), place->object(), "name");
}

std::string titleAt(const Scene& scene, std::string_view pointer) {
    const std::string object = objectPointer(scene, pointer);
    const auto place = locate(scene, object);
    if (!place || !place->field) return "scene";
    const std::vector<std::string> parts = partsOf(object);
    const std::string_view kind = place->objectStructure().name;
    if (parts.size() == 1) return std::string(kind);
    if (parts[0] == "blocks" && parts.size() == 2)
        return withName(kind, displayName(scene, static_cast<int>(*place->entry)));
    if (parts[0] == "supports") {
        const std::string side = textOf(place->objectStructure(), place->object(), "boundary");
        return side.empty() ? numbered(kind, parts.back()) : side + " support";
    }
    const std::string name = nameAt(scene, object);
    if (!name.empty()) return withName(kind, name);
    const std::string own = place->field->kind == FieldKind::List ? numbered(kind, parts.back()) : std::string(kind);
    return parts.size() > 2 ? own + " of " + titleAt(scene, parentOf(parentOf(object))) : own;
}

namespace {

std::string refusal(const Scene& scene, const std::string& pointer, const std::string& list, const std::string& name) {
    const bool mayBeEmpty = list == "/blocks";
    if (name.empty() && !mayBeEmpty) return "Enter a name.";
    std::vector<std::string> taken = namesBeside(scene, list);
    const auto own = std::find(taken.begin(), taken.end(), nameAt(scene, pointer));
    if (own != taken.end()) taken.erase(own);
    if (!name.empty() && std::find(taken.begin(), taken.end(), name) != taken.end())
        return "The name " + inQuotes(name) + " is already used. A free name is " +
               inQuotes(nameOfCopy(scene, list, name)) + ".";
    return {};
}

void follow(Scene& scene, Named kind, const std::string& from, const std::string& to) {
    // One text may contain several names. They are replaced from the end, so that earlier positions stay valid.
    std::vector<Reference> references = referencesOf(scene);
    for (auto at = references.rbegin(); at != references.rend(); ++at)
        if (at->kind == kind && at->name() == from) at->text->replace(at->at, at->length, to);
}

}  // namespace

Edit renameAt(const Scene& scene, const std::string& pointer, const std::string& name) {
    Edit edit{scene};
    const auto place = locate(edit.scene, pointer);
    const std::string list = parentOf(pointer);
    if (!place || !place->entry) return {scene, "There is no named object at " + pointer + "."};
    const std::string before = nameAt(scene, pointer);
    if (name == before) return edit;
    edit.refusal = refusal(scene, pointer, list, name);
    if (!edit.done()) return edit;
    Named kind;
    if (kindOfList(list, kind) && !before.empty() && !name.empty()) follow(edit.scene, kind, before, name);
    if (place->field->kind == FieldKind::Map) {
        const auto* type = findBoltType(scene, before);
        if (list == "/bolt_types" && type && type->builtIn)
            return {scene, "The bolt type " + inQuotes(before) + " is built in. Copy it to change it."};
        place->field->children.rename(changeable(place->owner), *place->entry, name);
        edit.pointers.renamed(list, before, name);
        edit.made = under(list, name);
    } else if (const Field* field = findField(place->objectStructure(), "name")) {
        field->set(changeable(place->object()), name);
    } else {
        return {scene, "A " + std::string(place->objectStructure().name) + " has no name."};
    }
    return edit;
}

}  // namespace keyblock
