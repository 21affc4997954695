// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What an edit gives back. Every edit is a function from one scene to the next;
// the scene that it was given is not touched, so undo is keeping it.
#pragma once

#include "solver/scene/scene.h"
#include "ui/edit/pointer_change.h"

#include <string>
#include <vector>

namespace keyblock {

/// The scene after an edit, or the one before it and why nothing was done.
struct Edit {
    Scene scene;
    std::string refusal{};  // a sentence for people; empty: the edit was done
    std::string made{};  // pointer of what is new, if something is
    PointerChange pointers{};  // where pointers of before lead now
    std::vector<std::string> told{};  // what else changed along with it, a sentence each

    bool done() const { return refusal.empty(); }
};

}  // namespace keyblock
