// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The result of an edit. Every edit is a function that returns a new scene and leaves
// the given one unchanged, so undo only has to keep the earlier scene.
#pragma once

#include "solver/scene/scene.h"
#include "ui/edit/pointer_change.h"

#include <string>
#include <vector>

namespace keyblock {

/// The scene after an edit, or the unchanged scene and the reason why the edit was refused.
struct Edit {
    Scene scene;
    std::string refusal{};  // reason, as a sentence for the user; empty: the edit was done
    std::string made{};  // JSON pointer of the new object, if any
    PointerChange pointers{};  // new pointers of objects that the edit has moved, renamed or removed
    std::vector<std::string> notes{};  // other changes that the edit entailed, one sentence each

    bool done() const { return refusal.empty(); }
};

}  // namespace keyblock
