// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/edit/remove.h"

#include "solver/scene/lookup.h"
#include "solver/scene/pointer.h"
#include "solver/scene/suggest.h"
#include "ui/edit/locate.h"
#include "ui/edit/names.h"
#include "ui/edit/object_references.h"
#include "ui/edit/settle.h"

#include <algorithm>
#include <map>
#include <set>

namespace keyblock {
namespace {

/// True if no other object of that kind has the name.
bool isLastOfName(const Scene& scene, Named kind, const std::string& name, const std::set<std::string>& going) {
    const std::string list = listOf(kind);
    if (locate(scene, list)->field->kind == FieldKind::Map) return true;
    const std::vector<std::string> names = namesOfKind(scene, kind);
    for (std::size_t i = 0; i < names.size(); ++i)
        if (names[i] == name && !going.contains(under(list, i))) return false;
    return true;
}

/// Everything that is deleted with the given objects.
struct Departure {
    std::set<std::string> objects;  // pointers of entries, elements and objects
    std::set<std::string> nulls;  // pointers of fields that become null
    std::vector<std::string> notes;
};

void goWith(const Scene& scene, const Reference& reference, const std::string& gone, Departure& out) {
    const std::string what = titleAt(scene, gone);
    switch (reference.whenGone) {
        case WhenGone::Null:
            if (out.nulls.insert(reference.pointer).second)
                out.notes.push_back("The " + titleAt(scene, reference.pointer) + " no longer refers to the " + what +
                                   ".");
            break;
        case WhenGone::Entry:
            out.objects.insert(reference.pointer);
            break;
        case WhenGone::Owner:
            if (out.objects.insert(parentOf(reference.pointer)).second)
                out.notes.push_back("The " + titleAt(scene, reference.pointer) + " was deleted with the " + what + ".");
            break;
        case WhenGone::Stays:
            out.notes.push_back("The " + titleAt(scene, reference.pointer) + " still refers to the " + what +
                               ". Choose another one.");
            break;
    }
}

/// References by kind and name.
using ByName = std::multimap<std::pair<Named, std::string>, Reference>;

ByName byName(const std::vector<Reference>& references) {
    ByName found;
    for (const Reference& reference : references) found.emplace(std::pair(reference.kind, reference.name()), reference);
    return found;
}

Departure departureOf(Scene& scene, const std::vector<std::string>& pointers) {
    Departure out;
    std::vector<std::string> open;
    for (const std::string& pointer : pointers) {
        const auto place = locate(scene, pointer);
        const bool leads = place && place->field && (place->isObject() || place->element);
        if (leads && out.objects.insert(pointer).second) open.push_back(pointer);
    }
    const ByName references = byName(referencesOf(scene));
    while (!open.empty()) {
        const std::string gone = open.back();
        open.pop_back();
        Named kind;
        if (!kindOfList(parentOf(gone), kind)) continue;
        const std::string name = nameAt(scene, gone);
        const auto [first, last] = references.equal_range({kind, name});
        if (first == last || !isLastOfName(scene, kind, name, out.objects)) continue;
        for (auto at = first; at != last; ++at) {
            const Reference& reference = at->second;
            if (liesIn(out.objects, reference.pointer)) continue;
            const std::size_t before = out.objects.size();
            goWith(scene, reference, gone, out);
            if (out.objects.size() > before && reference.whenGone == WhenGone::Owner)
                open.push_back(parentOf(reference.pointer));
        }
    }
    return out;
}

/// Entries of one list by decreasing index, so that a removal does not shift the remaining ones.
using Groups = std::map<std::string, std::vector<std::size_t>>;

void eraseElements(Scene& scene, const std::string& list, const std::vector<std::size_t>& indices) {
    const ScenePlace place = *locate(scene, list);
    FieldValue value = place.field->get(place.owner);
    for (const std::size_t index : indices) {
        const auto offset = static_cast<std::ptrdiff_t>(index);
        if (auto* points = std::get_if<std::vector<Point>>(&value)) points->erase(points->begin() + offset);
        if (auto* texts = std::get_if<std::vector<std::string>>(&value)) texts->erase(texts->begin() + offset);
    }
    place.field->set(changeable(place.owner), value);
}

std::size_t countOf(const ScenePlace& place) {
    if (hasChildren(*place.field)) return place.field->children.count(place.owner);
    const FieldValue value = place.field->get(place.owner);
    if (const auto* points = std::get_if<std::vector<Point>>(&value)) return points->size();
    return std::get<std::vector<std::string>>(value).size();
}

void erase(Edit& edit, const Scene& before, const std::set<std::string>& objects) {
    Groups groups;
    for (const std::string& pointer : objects) {
        const ScenePlace place = *locate(before, pointer);
        if (place.entry || place.element) {
            groups[parentOf(pointer)].push_back(place.element.value_or(place.entry.value_or(0)));
            if (place.entry && place.field->kind == FieldKind::Map) edit.pointers.removed(pointer);
        } else {
            locate(edit.scene, pointer)->field->children.setNull(changeable(locate(edit.scene, pointer)->owner));
            edit.pointers.removed(pointer);
        }
    }
    // Deeper lists first: a pointer into a stage is valid only until the stage moves.
    std::vector<std::pair<std::string, std::vector<std::size_t>>> order(groups.begin(), groups.end());
    std::stable_sort(order.begin(), order.end(), [](const auto& a, const auto& b) {
        return partsOf(a.first).size() > partsOf(b.first).size();
    });
    for (auto& [list, indices] : order) {
        std::sort(indices.rbegin(), indices.rend());
        const ScenePlace place = *locate(edit.scene, list);
        if (place.field->kind != FieldKind::Map)
            edit.pointers.removed(list, indices, countOf(*locate(before, list)));
        if (!hasChildren(*place.field)) {
            eraseElements(edit.scene, list, indices);
            continue;
        }
        for (const std::size_t index : indices) place.field->children.erase(changeable(place.owner), index);
    }
}

/// A line or an outline must keep its minimum number of points. \return an error text, or an empty text.
std::string tooShort(const Scene& scene, const std::set<std::string>& objects) {
    std::map<std::string, std::size_t> going;
    for (const std::string& pointer : objects)
        if (locate(scene, pointer)->element) ++going[parentOf(pointer)];
    for (const auto& [list, count] : going) {
        const ScenePlace place = *locate(scene, list);
        if (place.field->kind == FieldKind::TextList) continue;
        const std::size_t needed = list.starts_with("/joints") || place.field->kind == FieldKind::PointPair ? 2 : 3;
        if (countOf(place) < needed + count)
            return "The " + titleAt(scene, list) + " needs at least " + std::to_string(needed) +
                   " points. Delete the whole object.";
    }
    return {};
}

}  // namespace

Edit removeAll(const Scene& scene, const std::vector<std::string>& pointers) {
    Edit edit{scene};
    for (const std::string& pointer : pointers) {
        const std::vector<std::string> parts = partsOf(pointer);
        const BoltType* type = parts.size() > 1 && parts[0] == "bolt_types" ? findBoltType(scene, parts[1]) : nullptr;
        if (type && type->builtIn)
            return {scene, "The bolt type " + inQuotes(type->name) + " is built in and cannot be deleted."};
    }
    Departure departure = departureOf(edit.scene, pointers);
    if (departure.objects.empty()) return {scene, "There is nothing to delete."};
    edit.refusal = tooShort(scene, departure.objects);
    if (!edit.done()) return edit;
    for (const std::string& pointer : departure.nulls) {
        if (liesIn(departure.objects, pointer)) continue;
        const ScenePlace place = *locate(edit.scene, pointer);
        place.field->set(changeable(place.owner), {});
    }
    std::erase_if(departure.objects,
                  [&](const std::string& pointer) { return liesIn(departure.objects, parentOf(pointer)); });
    erase(edit, scene, departure.objects);
    edit.notes = std::move(departure.notes);
    settle(edit.scene);
    return edit;
}

Edit removeAt(const Scene& scene, const std::string& pointer) { return removeAll(scene, {pointer}); }

}  // namespace keyblock
