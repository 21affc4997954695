// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Moves or copies the whole selection.
#pragma once

#include "ui/edit/edit.h"

#include <string>
#include <vector>

namespace keyblock {

/// Shifts all points of the objects by `offset` [m]: corners, ends, centres, points of loads and monitors. Bolt
/// patterns move with their tunnel. Refused if a point would be too far from the origin, or if no object has a point.
Edit moveAll(const Scene& scene, const std::vector<std::string>& pointers, const Point& offset);

/// Adds copies of objects of `source` (the same scene or another one), shifted by `offset` [m], under unused names.
/// Copies refer to each other as the originals do. Within the same scene, copies are excavated, installed and removed
/// in the same stages as the originals. Materials and bolt types that are missing in `scene` are added. `Edit::notes`
/// lists what could not be copied.
/// \param made receives the JSON pointers of the copies.
Edit copyAll(const Scene& scene, const Scene& source, const std::vector<std::string>& pointers, const Point& offset,
             std::vector<std::string>& made);

}  // namespace keyblock
