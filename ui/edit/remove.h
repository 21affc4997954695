// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Deletes objects of a scene together with the objects that depend on them.
//
// References to a deleted object are treated as follows, and `Edit::notes` reports the
// changes. If the field may be null (the joint material of a joint, the region of a
// joint set), it becomes null. A name in a list (excavate, install) is removed from the
// list. An object that is meaningless without the deleted one (a pattern along a
// tunnel, a monitor of a bolt) is deleted too. If the field requires a name (the
// material of a block), the reference is kept, and the check reports that the object is
// missing.
#pragma once

#include "ui/edit/edit.h"

#include <string>
#include <vector>

namespace keyblock {

/// Deletes the objects to which the JSON pointers refer: entries of lists and maps, single points of a line, or objects
/// such as `/domain`. Invalid pointers are skipped; if all are invalid, the edit is refused.
Edit removeAll(const Scene& scene, const std::vector<std::string>& pointers);

/// Like `removeAll` for a single pointer.
Edit removeAt(const Scene& scene, const std::string& pointer);

}  // namespace keyblock
