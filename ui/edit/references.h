// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which fields of a scene name another object of it. One list serves renaming
// (names follow), deleting (who is concerned) and copying.
#pragma once

#include "solver/scene/scene.h"

#include <string>
#include <vector>

namespace keyblock {

/// What can be named. A list of the scene each.
enum class Named { Material, JointMaterial, Region, Tunnel, Block, Bolt, Pattern, BoltType, Joint, JointSet, Monitor };

/// What becomes of a reference when what it names goes.
enum class WhenGone {
    Stays,  // the field needs a name: the check tells
    Null,  // null says something by itself
    Entry,  // the text goes from its list
    Owner  // the object that holds it means nothing without
};

/// A name within a text of the scene.
struct Reference {
    Named kind = Named::Material;
    std::string pointer;  // of the text
    std::string* text = nullptr;  // in the scene that was asked
    std::size_t at = 0, length = 0;  // of the name in the text
    WhenGone whenGone = WhenGone::Stays;

    std::string name() const { return text->substr(at, length); }
};

/// All references, in the order of the scene's parts. Names that lead nowhere are those of the kind that they should be.
std::vector<Reference> referencesOf(Scene& scene);

/// The pointer of the list or map of that kind.
std::string listOf(Named kind);

/// The kind of what stands in the list of that pointer; false where nothing is named.
bool kindOfList(std::string_view list, Named& kind);

/// Names of that kind, in order.
std::vector<std::string> namesOfKind(const Scene& scene, Named kind);

}  // namespace keyblock
