// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/edit/settle.h"

#include "solver/files/scene/bolt_library.h"
#include "solver/scene/field.h"
#include "solver/scene/lookup.h"
#include "ui/edit/locate.h"

#include <algorithm>

namespace keyblock {
namespace {

constexpr int longestChain = 32;  // of derived types, the same limit as in the file reader

/// Resets a field that does not apply. \return true if this changed its value.
bool leaveOut(const Structure& structure, const Field& field, void* object) {
    if (applies(structure, field, object) || sameValue(field, object, structure.defaults)) return false;
    if (hasChildren(field)) field.children.setNull(object);
    else field.set(object, defaultOf(structure, field));
    return true;
}

/// Resets all fields that do not apply. This is repeated, because other fields may depend on a field that is reset.
void leaveOutMisplaced(const Structure& structure, void* object) {
    for (bool changed = true; changed;) {
        changed = false;
        for (const Field& field : structure.fields)
            if (!field.only.key.empty()) changed |= leaveOut(structure, field, object);
    }
    for (const Field& field : structure.fields) {
        if (!hasChildren(field)) continue;
        const Structure& inner = field.children.structure();
        for (std::size_t i = 0; i < field.children.count(object); ++i)
            leaveOutMisplaced(inner, changeable(field.children.item(object, i)));
    }
}

/// True if the chain of types from which this one is derived ends.
bool likeEnds(const Scene& scene, const BoltType& type) {
    const BoltType* at = &type;
    for (int link = 0; link < longestChain; ++link) {
        if (at->like.empty() || at->builtIn) return true;
        const BoltType* own = findBoltType(scene, at->like);
        const BoltType* next = own ? own : findBuiltInBoltType(at->like);
        if (!next) return false;
        at = next;
    }
    return false;
}

}  // namespace

void settle(Scene& scene) {
    leaveOutMisplaced(sceneStructure(), &scene);
    for (BoltType& type : scene.boltTypes)
        if (!likeEnds(scene, type)) type.like.clear();
    const auto isUsed = [&](const BoltType& type) {
        const auto names = [&](const auto& item) { return item.type == type.name; };
        return std::any_of(scene.bolts.begin(), scene.bolts.end(), names) ||
               std::any_of(scene.boltPatterns.begin(), scene.boltPatterns.end(), names);
    };
    std::erase_if(scene.boltTypes, [&](const BoltType& type) { return type.builtIn && !isUsed(type); });
    addUsedBuiltInBoltTypes(scene);
}

}  // namespace keyblock
