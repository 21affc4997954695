// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Finds the fields of a scene that refer to another object by name. Used to rename,
// delete and copy objects.
#pragma once

#include "solver/scene/scene.h"

#include <string>
#include <vector>

namespace keyblock {

/// Kinds of objects that other fields can refer to; each kind has its own list in the scene.
enum class Named { Material, JointMaterial, Region, Tunnel, Block, Bolt, Pattern, BoltType, Joint, JointSet, Monitor };

/// What happens to a reference when the object that it names is deleted.
enum class WhenGone {
    Stays,  // the reference is kept because the field requires a name; the check reports the missing object
    Null,  // the field becomes null
    Entry,  // the name is removed from its list
    Owner  // the object that contains the reference is deleted too
};

/// A reference to another object by its name. The name may be only part of a string in the scene, such as `P1` in
/// `P1.3`.
struct Reference {
    Named kind = Named::Material;
    std::string pointer;  // JSON pointer of the text
    std::string* text = nullptr;  // the text, within the given scene
    std::size_t at = 0, length = 0;  // position and length of the name within the text
    WhenGone whenGone = WhenGone::Stays;

    std::string name() const { return text->substr(at, length); }
};

/// All references, in the order in which they occur in the scene. `Reference::kind` is the kind of the object that has
/// the name; if no object has it, a kind that the field accepts.
std::vector<Reference> referencesOf(Scene& scene);

/// JSON pointer of the list or map that contains objects of this kind.
std::string listOf(Named kind);

/// Sets `kind` to the kind of the objects in the list at this JSON pointer; returns false if other fields cannot refer
/// to these objects.
bool kindOfList(std::string_view list, Named& kind);

/// Names of all objects of a kind, in the order of their list.
std::vector<std::string> namesOfKind(const Scene& scene, Named kind);

}  // namespace keyblock
