// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Moving and copying the selection as a whole.
#pragma once

#include "ui/edit/edit.h"

#include <string>
#include <vector>

namespace keyblock {

/// Shifts every point of the objects by `offset` [m]: corners, ends, centres, points of loads and monitors. Patterns
/// move with their tunnel. Refused if a point would be too far away or no object has a point.
Edit moveAll(const Scene& scene, const std::vector<std::string>& pointers, const Point& offset);

/// Adds copies of objects of `source` (the same scene or another), shifted by `offset` [m], with free names. Copies are
/// excavated, installed and removed in the stages of the originals if it is the same scene; they refer to each other
/// as the originals do. Materials and types missing in `scene` are added. `Edit::notes` lists what was not copied.
/// \param made receives the pointers of the copies.
Edit copyAll(const Scene& scene, const Scene& source, const std::vector<std::string>& pointers, const Point& offset,
             std::vector<std::string>& made);

}  // namespace keyblock
