// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Taking things out of a scene together with what means nothing without them.
//
// What named them follows one rule, told in `Edit::told`: where nothing given has a
// meaning of its own (the joint material of a joint, the region of a set) the name
// is left out; a name in a list (excavate, install) goes from it; an object that
// exists for what it names (a pattern along a tunnel, a monitor of a bolt) goes
// along; where a name is needed (the material of a block) it stays, and the check
// tells what is missing.
#pragma once

#include "ui/edit/edit.h"

#include <string>
#include <vector>

namespace keyblock {

/// Takes out what the pointers lead to: entries of lists and maps, single points of a line, objects such as `/domain`.
/// Pointers that lead nowhere are passed over; without any left the edit is refused.
Edit removeAll(const Scene& scene, const std::vector<std::string>& pointers);

Edit removeAt(const Scene& scene, const std::string& pointer);

}  // namespace keyblock
