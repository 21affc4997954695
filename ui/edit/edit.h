// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The result of an edit. Every edit is a function from one scene to the next; the
// given scene is not changed, so undo only has to keep it.
#pragma once

#include "solver/scene/scene.h"
#include "ui/edit/pointer_change.h"

#include <string>
#include <vector>

namespace keyblock {

/// The scene after an edit, or the one before it and why nothing was done.
struct Edit {
    Scene scene;
    std::string refusal{};  // a sentence for the user; empty: the edit was done
    std::string made{};  // pointer of the new object, if any
    PointerChange pointers{};  // maps earlier pointers to the new ones
    std::vector<std::string> notes{};  // other changes made along with it, a sentence each

    bool done() const { return refusal.empty(); }
};

}  // namespace keyblock
