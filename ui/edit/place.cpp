// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/edit/place.h"

#include "solver/scene/field.h"
#include "solver/scene/lookup.h"
#include "solver/scene/pointer.h"
#include "ui/edit/locate.h"
#include "ui/edit/names.h"
#include "ui/edit/object_references.h"
#include "ui/edit/settle.h"

#include <algorithm>
#include <map>
#include <set>

namespace keyblock {
namespace {

bool isPlace(const Field& field) {
    return field.unit == "m" && (field.kind == FieldKind::Vector || field.kind == FieldKind::PointPair ||
                                 field.kind == FieldKind::Points);
}

/// Shifts the points of an object and its children. \return false if a point would be too far away.
bool shift(const Structure& structure, void* object, const Point& offset, int& places) {
    bool near = true;
    for (const Field& field : structure.fields) {
        if (hasChildren(field)) {
            for (std::size_t i = 0; i < field.children.count(object); ++i)
                near &= shift(field.children.structure(), changeable(field.children.item(object, i)), offset, places);
            continue;
        }
        if (!field.get || !isPlace(field) || !applies(structure, field, object)) continue;
        FieldValue value = field.get(object);
        if (auto* point = std::get_if<Point>(&value)) {
            *point += offset;
            near &= isUsable(*point);
            ++places;
        }
        if (auto* points = std::get_if<std::vector<Point>>(&value)) {
            for (Point& point : *points) near &= isUsable(point += offset);
            places += static_cast<int>(points->size());
        }
        field.set(object, value);
    }
    return near;
}

/// The pointers, without those of objects inside other ones, and the patterns of the selected tunnels.
std::set<std::string> withPatterns(const Scene& scene, const std::vector<std::string>& pointers) {
    std::set<std::string> all(pointers.begin(), pointers.end());
    for (std::size_t i = 0; i < scene.boltPatterns.size(); ++i)
        for (std::size_t t = 0; t < scene.tunnels.size(); ++t)
            if (scene.tunnels[t].name == scene.boltPatterns[i].tunnel && all.contains(under("/tunnels", t)))
                all.insert(under("/bolt_patterns", i));
    std::erase_if(all, [&](const std::string& pointer) { return liesIn(all, parentOf(pointer)); });
    return all;
}

/// Shifts one point of a line, or one field that is a point.
bool shiftSingle(const ScenePlace& place, const Point& offset, int& places) {
    if (!place.field || !isPlace(*place.field)) return true;
    FieldValue value = place.field->get(place.owner);
    bool near = true;
    if (auto* point = std::get_if<Point>(&value)) near = isUsable(*point += offset);
    if (auto* points = std::get_if<std::vector<Point>>(&value))
        for (std::size_t i = 0; i < points->size(); ++i)
            if (!place.element || *place.element == i) near &= isUsable((*points)[i] += offset);
    place.field->set(changeable(place.owner), value);
    ++places;
    return near;
}

/// Copies entries of lists one after another.
class Copier {
public:
    Copier(const Scene& scene, const Scene& source, const Point& offset)
        : edit_{scene}, source_(source), offset_(offset), sameScene_(&scene == &source || scene == source) {}

    void copy(const std::string& pointer, std::vector<std::string>& made) {
        const auto from = locate(source_, pointer);
        const std::string list = parentOf(pointer);
        const auto to = locate(edit_.scene, list);
        if (!from || !from->entry || !to || !to->field || !hasChildren(*to->field) || to->entry) {
            edit_.notes.push_back("The " + titleAt(source_, pointer) + " was not copied: a scene has only one.");
            return;
        }
        const Children& children = to->field->children;
        const std::string before = nameAt(source_, pointer);
        const std::string name = before.empty() ? before : nameOfCopy(edit_.scene, list, before);
        void* copied = children.append(changeable(to->owner), name);
        children.assign(copied, from->object());
        const Structure& structure = children.structure();
        if (const Field* field = findField(structure, "name"); field && to->field->kind == FieldKind::List)
            field->set(copied, name);
        near_ &= shift(structure, copied, offset_, places_);
        const std::string pointerOfCopy = to->field->kind == FieldKind::Map
                                              ? under(list, name)
                                              : under(list, children.count(to->owner) - 1);
        made.push_back(pointerOfCopy);
        names_[{list, before}] = name;
    }

    Edit finish(const std::vector<std::string>& made) {
        if (made.empty()) return {std::move(edit_.scene), "There is nothing to copy."};
        if (!near_) return {std::move(edit_.scene), "The copy would be too far away."};
        const std::set<std::string> ours(made.begin(), made.end());
        nameEachOther(ours);
        if (sameScene_) comeAndGoWithOriginals();
        bringAlong(ours);
        settle(edit_.scene);
        edit_.made = made.front();
        return std::move(edit_);
    }

private:
    void nameEachOther(const std::set<std::string>& made) {
        std::vector<Reference> references = referencesOf(edit_.scene);
        for (auto at = references.rbegin(); at != references.rend(); ++at) {
            const auto name = names_.find({listOf(at->kind), at->name()});
            if (liesIn(made, at->pointer) && name != names_.end()) at->text->replace(at->at, at->length, name->second);
        }
    }

    void comeAndGoWithOriginals() {
        for (Stage& stage : edit_.scene.stages)
            for (std::vector<std::string>* list : {&stage.excavate, &stage.install, &stage.remove})
                for (const auto& [original, copy] : names_) {
                    const std::string& kind = original.first;
                    const bool fits = list == &stage.excavate ? kind == "/tunnels" || kind == "/blocks"
                                                              : kind == "/bolts" || kind == "/bolt_patterns";
                    if (fits && std::find(list->begin(), list->end(), original.second) != list->end())
                        list->push_back(copy);
                }
    }

    /// Adds objects that the copies refer to and that this scene lacks.
    void bringAlong(const std::set<std::string>& made) {
        Scene& scene = edit_.scene;
        for (const Reference& reference : referencesOf(scene)) {
            const std::string name = reference.name();
            if (!liesIn(made, reference.pointer)) continue;
            const auto bring = [&](auto Scene::*map) {
                const auto isIt = [&](const auto& entry) { return entry.first == name; };
                const auto found = std::find_if((source_.*map).begin(), (source_.*map).end(), isIt);
                const bool has = std::any_of((scene.*map).begin(), (scene.*map).end(), isIt);
                if (found != (source_.*map).end() && !has) (scene.*map).push_back(*found);
            };
            if (reference.kind == Named::Material) bring(&Scene::materials);
            if (reference.kind == Named::JointMaterial) bring(&Scene::jointMaterials);
            const BoltType* type = reference.kind == Named::BoltType ? findBoltType(source_, name) : nullptr;
            if (type && !findBoltType(scene, name)) scene.boltTypes.push_back(*type);
        }
    }

    Edit edit_;
    const Scene& source_;
    Point offset_;
    bool sameScene_;
    bool near_ = true;
    int places_ = 0;
    std::map<std::pair<std::string, std::string>, std::string> names_;  // list and name → name of the copy
};

}  // namespace

Edit moveAll(const Scene& scene, const std::vector<std::string>& pointers, const Point& offset) {
    Edit edit{scene};
    if (offset.isZero(0.0)) return edit;
    int places = 0;
    bool near = offset.allFinite();
    for (const std::string& pointer : withPatterns(scene, pointers)) {
        const auto place = locate(edit.scene, pointer);
        if (!place || !place->field) continue;
        near &= place->isObject() ? shift(place->objectStructure(), changeable(place->object()), offset, places)
                                  : shiftSingle(*place, offset, places);
    }
    if (!near) return {scene, "The moved objects would be too far away."};
    if (places == 0) return {scene, "None of the selected objects can be moved."};
    return edit;
}

Edit copyAll(const Scene& scene, const Scene& source, const std::vector<std::string>& pointers, const Point& offset,
             std::vector<std::string>& made) {
    Copier copier(scene, source, offset);
    made.clear();
    for (const std::string& pointer : pointers) copier.copy(pointer, made);
    Edit edit = copier.finish(made);
    if (!edit.done()) return {scene, edit.refusal};
    return edit;
}

}  // namespace keyblock
