// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Deletes objects of a scene together with the objects that depend on them.
//
// References to a deleted object follow one rule; `Edit::notes` reports the changes.
// If null is a valid value (the joint material of a joint, the region of a set), the
// reference becomes null; a name in a list (excavate, install) is removed; an object
// that is meaningless without the deleted one (a pattern along a tunnel, a monitor
// of a bolt) is deleted too; if a name is required (the material of a block), it
// stays, and the check reports what is missing.
#pragma once

#include "ui/edit/edit.h"

#include <string>
#include <vector>

namespace keyblock {

/// Deletes what the pointers lead to: entries of lists and maps, single points of a line, objects such as `/domain`.
/// Invalid pointers are skipped; if none is left, the edit is refused.
Edit removeAll(const Scene& scene, const std::vector<std::string>& pointers);

Edit removeAt(const Scene& scene, const std::string& pointer);

}  // namespace keyblock
