// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where four or more blocks meet at a point, some of them share only that corner and
// no face. As long as bonds connect them through the other blocks at that point, they
// need no contact of their own. A contact between the two corners would be an extra
// spring that acts in compression only and would make the stiffness of intact rock
// non-uniform.
#pragma once

#include "solver/engine/model/state.h"

#include <vector>

namespace keyblock {

/// Removes contacts that carry no force if their two blocks are connected, through other blocks, by bonds that are at
/// the same point in the original scene (theory, "Contacts"). The order of the remaining contacts is kept.
void dropHeldCorners(const Model& model, std::vector<Contact>& contacts);

}  // namespace keyblock
