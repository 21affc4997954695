// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Moving and copying what a person chose, as a whole.
#pragma once

#include "ui/edit/edit.h"

#include <string>
#include <vector>

namespace keyblock {

/// Shifts every place of the objects by `offset` [m]: corners, ends, middles, what a load or a monitor looks at. Patterns
/// go with their tunnel. Refused where a place would come to lie too far away, or nothing has a place.
Edit moveAll(const Scene& scene, const std::vector<std::string>& pointers, const Point& offset);

/// Adds copies of objects of `source` (the same scene or another), shifted by `offset` [m], under free names. Copies are
/// excavated, installed and removed in the stages where the originals are, if it is the same scene; they name each other
/// where the originals do. Materials and types that `scene` lacks come along. `Edit::told` names what has no copy.
/// \param made takes the pointers of the copies.
Edit copyAll(const Scene& scene, const Scene& source, const std::vector<std::string>& pointers, const Point& offset,
             std::vector<std::string>& made);

}  // namespace keyblock
