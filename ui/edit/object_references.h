// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The fields of a scene that refer to another object by name. Used for renaming,
// deleting and copying.
#pragma once

#include "solver/scene/scene.h"

#include <string>
#include <vector>

namespace keyblock {

/// Objects that can be referred to; each kind is one list of the scene.
enum class Named { Material, JointMaterial, Region, Tunnel, Block, Bolt, Pattern, BoltType, Joint, JointSet, Monitor };

/// What happens to a reference when its object is deleted.
enum class WhenGone {
    Stays,  // the field needs a name: the check reports it
    Null,  // null is a valid value
    Entry,  // the text is removed from its list
    Owner  // the object with the reference is deleted too
};

/// A name within a text of the scene.
struct Reference {
    Named kind = Named::Material;
    std::string pointer;  // of the text
    std::string* text = nullptr;  // in the given scene
    std::size_t at = 0, length = 0;  // of the name in the text
    WhenGone whenGone = WhenGone::Stays;

    std::string name() const { return text->substr(at, length); }
};

/// All references, in the order of the scene's parts. Unknown names have the kind that the field expects.
std::vector<Reference> referencesOf(Scene& scene);

/// The pointer of the list or map of that kind.
std::string listOf(Named kind);

/// The kind of the objects in the list at that pointer; false if they cannot be referred to.
bool kindOfList(std::string_view list, Named& kind);

/// Names of that kind, in order.
std::vector<std::string> namesOfKind(const Scene& scene, Named kind);

}  // namespace keyblock
